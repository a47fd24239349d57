// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/safety_guard.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace enfilade::explorer {
namespace {

constexpr int kSteps = 12;

/// Where the base is after `way_m` along the arc of `velocity`.
Point2 after(const VelocityCommand& velocity, double way_m) {
  const double curvature = velocity.angular_rad_s / velocity.linear_m_s;
  if (std::abs(curvature) < 1e-3) return {way_m, 0.0};
  return {std::sin(curvature * way_m) / curvature, (1.0 - std::cos(curvature * way_m)) / curvature};
}

}  // namespace

SafetyGuard::SafetyGuard(const SafetyGuardConfig& config) : config_(config) {
  if (!(config.deceleration_m_s2 > 0.0))
    throw std::invalid_argument("SafetyGuard: deceleration_m_s2 must be positive");
}

std::vector<Point2> SafetyGuard::in_the_way(const VelocityCommand& velocity,
                                            const std::vector<Point3f>& points) const {
  std::vector<Point2> found;
  const double v = std::abs(velocity.linear_m_s);
  if (v < 1e-3) return found;
  const double reach_m = config_.ahead_m + v * config_.latency_s + v * v / (2.0 * config_.deceleration_m_s2);
  const double keep_m = config_.robot_radius_m + config_.side_margin_m;
  const double sign = velocity.linear_m_s > 0.0 ? 1.0 : -1.0;
  for (const Point3f& p : points) {
    if (p.z_m < config_.lowest_m || p.z_m > config_.highest_m) continue;
    const Point2 at{p.x_m, p.y_m};
    const double now_m = at.norm();
    if (now_m > keep_m + reach_m) continue;
    for (int i = 1; i <= kSteps; ++i) {
      const double then_m = (at - after(velocity, sign * reach_m * i / kSteps)).norm();
      if (then_m >= keep_m || then_m >= now_m) continue;
      found.push_back(at);
      break;
    }
  }
  return found;
}

}  // namespace enfilade::explorer
