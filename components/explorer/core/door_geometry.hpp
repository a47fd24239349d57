// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "interfaces/model/topological_map.hpp"

namespace enfilade::explorer {

struct DoorGeometryConfig {
  double max_size_difference_m = 0.25;  ///< an estimate whose sides differ more is not of this room
  double max_shift_m = 0.6;             ///< nor one whose centre is farther from where the room should be
  double max_turn_deg = 15.0;
  double same_door_m = 0.5;  ///< a gap whose middle is this near is the door
  double new_door_m = 0.6;   ///< a gap this wide where the graph has no door is worth telling
};

/// A door in the zone's frame: its middle in the plane of the wall's inner face and the direction out of the
/// room.
struct PlacedDoor {
  Point2 middle = Point2::Zero();
  Point2 outward{1.0, 0.0};
  double width_m = 0.0;

  double yaw_rad() const;
  /// On the door's normal through its middle, `outside_m` beyond the wall's inner face (negative: inside),
  /// facing out.
  Pose2 pose_at(double outside_m) const;
};

/// Where the room is in the zone's frame: by the freshest estimate that fits the stored room, else where the
/// graph has it. Estimates do not tell a rectangle from itself turned by a quarter: the graph does.
Pose2 locate_room(const Room& room, const Pose2& T_map_zone, const RoomEstimate* estimate,
                  const DoorGeometryConfig& config);

PlacedDoor place_door(const Room& room, const DoorFace& face, const Pose2& T_zone_room);

/// Adds points across the doorway, which nothing that keeps clear of them goes through.
void add_threshold(const PlacedDoor& door, std::vector<Point2>& points);

/// The gap of the estimate that is this door.
const DoorEstimate* find_gap(const RoomEstimate& estimate, const PlacedDoor& door,
                             const DoorGeometryConfig& config);

/// Whether the estimate is of this room and shows an open door where the graph has none.
bool shows_new_door(const RoomEstimate& estimate, const TopologicalMap& map, const Room& room,
                    const Pose2& T_zone_room, const DoorGeometryConfig& config);

}  // namespace enfilade::explorer
