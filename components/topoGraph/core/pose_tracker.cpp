// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/pose_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace enfilade::topo_graph {
namespace {

double turn(const Pose2& before, const Pose2& after) {
  return std::abs(wrap_to_pi(after.yaw_rad - before.yaw_rad));
}

}  // namespace

Pose2 model_deviation(const Pose2& before, const Pose2& after) {
  const double delta_alpha = wrap_to_pi(after.yaw_rad - before.yaw_rad);                   // eq. 18
  const Point2 delta_t = after.translation() - rotate(delta_alpha, before.translation());  // eq. 19
  return {delta_t.x(), delta_t.y(), delta_alpha};
}

std::vector<Pose2> namings(const Rectangle& reference, const Rectangle& seen, double max_size_difference_m) {
  std::vector<Pose2> poses;
  for (int quarter = 0; quarter < 4; ++quarter) {
    double width_m = seen.width_m, height_m = seen.height_m;
    if (quarter % 2 != 0) std::swap(width_m, height_m);
    const bool fits = std::abs(width_m - reference.width_m) <= max_size_difference_m &&
                      std::abs(height_m - reference.height_m) <= max_size_difference_m;
    if (fits) poses.push_back(seen.pose() * Pose2{0.0, 0.0, 0.5 * kPi * quarter});
  }
  return poses;
}

PoseTracker::PoseTracker(const PoseTrackerConfig& config) : config_(config) {
  const bool sane = config.max_size_difference_m >= 0.0 && config.max_shift_m > 0.0 &&
                    config.max_turn_rad > 0.0 && config.max_turn_rad < 0.25 * kPi &&
                    config.min_shift_m >= 0.0 && config.min_turn_rad >= 0.0;
  if (!sane)
    throw std::invalid_argument("PoseTracker: limits must be positive and max_turn below 45 degrees");
}

std::optional<Pose2> PoseTracker::deviation(const Rectangle& reference, const Rectangle& seen) const {
  const std::vector<Pose2> poses = namings(reference, seen, config_.max_size_difference_m);
  const auto nearest = std::min_element(poses.begin(), poses.end(), [&](const Pose2& a, const Pose2& b) {
    return turn(reference.pose(), a) < turn(reference.pose(), b);
  });
  if (nearest == poses.end() || turn(reference.pose(), *nearest) > config_.max_turn_rad) return std::nullopt;
  // The gate is on the centre's shift, not on |Δt| of eq. 19, which also holds the lever of the room's
  // distance from the frame's origin; the robot may turn at either end of the room.
  const double lever_m = 0.5 * std::max(reference.width_m, reference.height_m);
  const double limit_m = config_.max_shift_m + lever_m * turn(reference.pose(), *nearest);
  if ((nearest->translation() - reference.pose().translation()).norm() > limit_m) return std::nullopt;
  return model_deviation(reference.pose(), *nearest);
}

bool PoseTracker::is_significant(const Rectangle& reference, const Pose2& deviation) const {
  const Point2 centre = reference.pose().translation();
  return (deviation * centre - centre).norm() > config_.min_shift_m ||
         std::abs(deviation.yaw_rad) > config_.min_turn_rad;
}

}  // namespace enfilade::topo_graph
