// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/common_door.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace enfilade::topo_graph {
namespace {

Pose2 turn_about(const Point2& pivot, double angle_rad) {
  const Point2 shift = pivot - rotate(angle_rad, pivot);
  return {shift.x(), shift.y(), angle_rad};
}

double angle_of(const Point2& v) { return std::atan2(v.y(), v.x()); }

/// The gap of the new room that shows the known door: the nearest of those that look at it.
std::optional<WallInterval> find_gap(const PlacedFace& known, const Rectangle& rectangle,
                                     const std::vector<DoorEstimate>& doors, const CommonDoorConfig& config) {
  std::optional<WallInterval> best;
  double best_distance = config.max_distance_m;
  for (const DoorEstimate& door : doors) {
    const PlacedFace face = place(rectangle, door.gap);
    const double away = (face.midpoint() - known.midpoint()).norm();
    const bool same_width =
        std::abs(face.segment.length() - known.segment.length()) <= config.max_width_difference_m;
    if (door.state == DoorState::kUnexplored || !same_width || away > best_distance ||
        !back_to_back(known, face, config.max_angle_rad)) {
      continue;
    }
    best = door.gap;
    best_distance = away;
  }
  return best;
}

/// The shortest turn about the face's midpoint that makes the two walls parallel.
Pose2 parallel_turn(const PlacedFace& known, const PlacedFace& face, double max_rotation_rad) {
  const double angle = wrap_to_pi(angle_of(-known.normal) - angle_of(face.normal));
  return std::abs(angle) <= max_rotation_rad ? turn_about(face.midpoint(), angle) : Pose2{};
}

}  // namespace

CommonDoorSolver::CommonDoorSolver(const CommonDoorConfig& config) : config_(config) {
  const bool sane = config.max_thickness_m >= 0.0 && config.max_rotation_rad >= 0.0 &&
                    config.max_distance_m > 0.0 && config.max_angle_rad > 0.0 &&
                    config.max_angle_rad < 0.5 * kPi && config.max_width_difference_m > 0.0;
  if (!sane)
    throw std::invalid_argument("CommonDoorSolver: limits must be positive and max_angle below 90 degrees");
}

CommonDoor CommonDoorSolver::solve(const PlacedFace& known, const Rectangle& rectangle,
                                   const std::vector<DoorEstimate>& doors) const {
  const std::optional<WallInterval> seen = find_gap(known, rectangle, doors, config_);
  CommonDoor door{.seen = seen.has_value()};
  door.gap = seen ? *seen : project_on_nearest_wall(known, rectangle, config_.max_angle_rad);
  const PlacedFace face = place(rectangle, door.gap);
  const Point2 offset = face.midpoint() - known.midpoint();  // eq. 20: T_r2·d_r2 − T_r1·d_r1
  const double across_m = offset.dot(known.normal);
  door.thickness_m = across_m;
  door.corrected =
      offset.norm() <= config_.max_distance_m && back_to_back(known, face, config_.max_angle_rad);
  if (!door.corrected) return door;

  const bool paper = config_.door_faces == DoorFaces::kPaper;
  door.thickness_m = paper ? 0.0 : std::clamp(across_m, 0.0, config_.max_thickness_m);
  const Point2 shift = door.thickness_m * known.normal - offset;
  door.correction = Pose2{shift.x(), shift.y(), 0.0} *
                    (paper ? Pose2{} : parallel_turn(known, face, config_.max_rotation_rad));
  return door;
}

}  // namespace enfilade::topo_graph
