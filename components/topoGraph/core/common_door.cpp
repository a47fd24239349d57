// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/common_door.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace enfilade::topo_graph {
namespace {

constexpr double kTold_m = 0.05;       // odometry may miss by so much on the way through a door
constexpr double kSameWidth_m = 0.03;  // faces of one door differ by no more where both were seen whole

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

/// How far the new face lies off along the wall. Where its width is another one, a jamb was hidden from one
/// of the two rooms: the other jamb, that odometry misses by less, tells.
double along_wall_m(const PlacedFace& known, const PlacedFace& face) {
  const Point2 along = known.segment.direction();
  const double first_m = (face.segment.to - known.segment.from).dot(along);
  const double second_m = (face.segment.from - known.segment.to).dot(along);
  if (std::abs(first_m - second_m) <= kSameWidth_m) return 0.5 * (first_m + second_m);
  return std::abs(first_m) < std::abs(second_m) ? first_m : second_m;
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

  if (across_m > -kTold_m && across_m < config_.max_thickness_m + kTold_m)
    door.measured_thickness_m = std::max(0.0, across_m);
  const bool paper = config_.door_faces == DoorFaces::kPaper;
  door.thickness_m = paper ? 0.0 : std::clamp(across_m, 0.0, config_.max_thickness_m);
  const Pose2 turn = paper ? Pose2{} : parallel_turn(known, face, config_.max_rotation_rad);
  const Point2 along = known.segment.direction();
  const double along_m = paper ? offset.dot(along) : along_wall_m(known, place(turn * rectangle, door.gap));
  const Point2 shift = (door.thickness_m - across_m) * known.normal - along_m * along;
  door.correction = Pose2{shift.x(), shift.y(), 0.0} * turn;
  if (!paper && door.gap.width_m() < known.segment.length() - kSameWidth_m)
    door.gap = project_on_nearest_wall(known, door.correction * rectangle, config_.max_angle_rad);
  return door;
}

}  // namespace enfilade::topo_graph
