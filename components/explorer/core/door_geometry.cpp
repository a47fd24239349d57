// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/door_geometry.hpp"

#include <cmath>

#include "components/explorer/core/rectangle_naming.hpp"

namespace enfilade::explorer {
namespace {

/// The pose of `seen`, named as the room is, if it can be the room.
std::optional<Pose2> match(const Room& room, const Pose2& T_zone_room, const Rectangle& seen,
                           const DoorGeometryConfig& config) {
  const Rectangle named = named_towards(seen, T_zone_room.yaw_rad);
  const bool same_size = std::abs(named.width_m - room.width_m) <= config.max_size_difference_m &&
                         std::abs(named.height_m - room.height_m) <= config.max_size_difference_m;
  const bool same_place =
      (named.pose().translation() - T_zone_room.translation()).norm() <= config.max_shift_m &&
      std::abs(wrap_to_pi(named.yaw_rad - T_zone_room.yaw_rad)) <= radians(config.max_turn_deg);
  if (!same_size || !same_place) return std::nullopt;
  return named.pose();
}

}  // namespace

double PlacedDoor::yaw_rad() const { return std::atan2(outward.y(), outward.x()); }

Pose2 PlacedDoor::pose_at(double outside_m) const {
  const Point2 p = middle + outward * outside_m;
  return {p.x(), p.y(), yaw_rad()};
}

Pose2 locate_room(const Room& room, const Pose2& T_map_zone, const RoomEstimate* estimate,
                  const DoorGeometryConfig& config) {
  const Pose2 T_zone_room = T_map_zone.inverse() * room.T_map_room;
  if (!estimate || !estimate->found) return T_zone_room;
  if (estimate->recent && estimate->recent_stamp_ns > room.fixed_ns) {
    if (const auto seen = match(room, T_zone_room, *estimate->recent, config)) return *seen;
  }
  return match(room, T_zone_room, estimate->rectangle, config).value_or(T_zone_room);
}

PlacedDoor place_door(const Room& room, const DoorFace& face, const Pose2& T_zone_room) {
  const Rectangle placed{T_zone_room.yaw_rad, T_zone_room.x_m, T_zone_room.y_m, room.width_m, room.height_m};
  const Segment segment = segment_of(placed, face.gap);
  return {
      .middle = segment.midpoint(), .outward = placed.normal(face.gap.wall), .width_m = face.gap.width_m()};
}

void add_threshold(const PlacedDoor& door, std::vector<Point2>& points) {
  constexpr double kStepM = 0.05, kBeyondM = 0.10;
  const Point2 along{-door.outward.y(), door.outward.x()};
  for (double s = -0.5 * door.width_m; s <= 0.5 * door.width_m; s += kStepM)
    points.push_back(door.middle + kBeyondM * door.outward + s * along);
}

const DoorEstimate* find_gap(const RoomEstimate& estimate, const PlacedDoor& door,
                             const DoorGeometryConfig& config) {
  const DoorEstimate* nearest = nullptr;
  double nearest_m = config.same_door_m;
  for (const DoorEstimate& candidate : estimate.doors) {
    const double distance_m = (segment_of(estimate.rectangle, candidate.gap).midpoint() - door.middle).norm();
    const bool same_wall = estimate.rectangle.normal(candidate.gap.wall).dot(door.outward) > 0.7;
    if (!same_wall || distance_m >= nearest_m) continue;
    nearest_m = distance_m;
    nearest = &candidate;
  }
  return nearest;
}

bool shows_new_door(const RoomEstimate& estimate, const TopologicalMap& map, const Room& room,
                    const Pose2& T_zone_room, const DoorGeometryConfig& config) {
  if (!estimate.found || !match(room, T_zone_room, estimate.rectangle, config)) return false;
  RoomEstimate unknown = estimate;
  std::erase_if(unknown.doors, [&](const DoorEstimate& door) {
    return door.state != DoorState::kOpen || door.gap.width_m() < config.new_door_m;
  });
  for (const Door& door : map.doors) {
    const DoorFace* face = TopologicalMap::find_face(door, room.id);
    if (!face) continue;
    const PlacedDoor placed = place_door(room, *face, T_zone_room);
    while (const DoorEstimate* gap = find_gap(unknown, placed, config))
      unknown.doors.erase(unknown.doors.begin() + (gap - unknown.doors.data()));
  }
  return !unknown.doors.empty();
}

}  // namespace enfilade::explorer
