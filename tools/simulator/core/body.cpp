// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/body.hpp"

#include <algorithm>
#include <stdexcept>

#include "tools/simulator/core/shapes.hpp"

namespace enfilade::simulator {
namespace {

/// A contact ends when the hull is this far away, so that a robot that trembles against a wall has touched it
/// once.
constexpr double kRelease_m = 0.01;
constexpr double kFar_m = 10.0;

}  // namespace

Body::Body(const BodyConfig& config, const World& world) : config_(config) {
  if (config.radius_m <= 0 || config.height_m <= 0 || config.contact_height_m <= 0)
    throw std::invalid_argument("BodyConfig: sizes must be greater than 0");
  for (const Solid& solid : world.solids)
    if (in_the_way(solid, config.contact_height_m)) fixed_.push_back(solid.base);
}

double Body::clearance_m(const Point2& position, const std::vector<std::vector<Point2>>& moving) const {
  double nearest_m = kFar_m;
  for (const auto* obstacles : {&fixed_, &moving})
    for (const auto& polygon : *obstacles) nearest_m = std::min(nearest_m, distance(position, polygon));
  return nearest_m - config_.radius_m;
}

Pose2 Body::move(const Pose2& from, const Pose2& to, const std::vector<std::vector<Point2>>& moving) {
  if (from.translation() == to.translation() && !touching_) return to;
  const double after_m = clearance_m(to.translation(), moving);
  if (after_m > kRelease_m) touching_ = false;
  if (after_m > 0.0) return to;
  if (!touching_) ++collisions_;
  touching_ = true;
  const bool leaving = after_m > clearance_m(from.translation(), moving);
  return leaving ? to : Pose2{from.x_m, from.y_m, to.yaw_rad};
}

}  // namespace enfilade::simulator
