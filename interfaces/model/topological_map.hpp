// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interfaces/model/room.hpp"

namespace enfilade {

using RoomId = std::uint32_t;  ///< from 1; 0 on the wire means "none"
using DoorId = std::uint32_t;  ///< from 1

enum class DoorKind : std::uint8_t {
  kUnresolved = 0,  ///< seen from one side only
  kPassage = 1,     ///< joins two rooms
  kExit = 2,        ///< leads outside: no room lies behind it
  kBlocked = 3,     ///< looked at closely and found to be no way through
};

/// A door as one room sees it: a gap in one of its walls, in the room's own frame.
struct DoorFace {
  RoomId room = 0;
  WallInterval gap;

  bool operator==(const DoorFace&) const = default;
};

/// An edge of the graph. The first face belongs to the room from which the door was first seen.
struct Door {
  DoorId id = 0;
  DoorKind kind = DoorKind::kUnresolved;
  DoorFace face;
  std::optional<DoorFace> other_face;
  std::optional<double> height_m;

  bool operator==(const Door&) const = default;
};

/// A node of the graph.
struct Room {
  RoomId id = 0;
  std::string name;
  Pose2 T_map_room;  ///< the paper's T_r (eq. 17)
  double width_m = 0.0;
  double height_m = 0.0;
  std::optional<RectangleCovariance> covariance;
  std::vector<Point2> polygon;  ///< room frame; empty = the rectangle itself
  std::uint32_t zone_id = 0;    ///< the zone it was modelled in
  StampNs fixed_ns = 0;

  Rectangle rectangle() const {
    return {T_map_room.yaw_rad, T_map_room.x_m, T_map_room.y_m, width_m, height_m};
  }
  bool operator==(const Room&) const = default;
};

struct TopologicalMap {
  std::uint64_t version = 0;  ///< grows with every accepted change
  StampNs stamp_ns = 0;
  std::vector<Room> rooms;  ///< by id
  std::vector<Door> doors;  ///< by id

  const Room* find_room(RoomId id) const;
  const Door* find_door(DoorId id) const;
  /// The door as seen from `room`; null where the door does not belong to it.
  static const DoorFace* find_face(const Door& door, RoomId room);

  bool operator==(const TopologicalMap&) const = default;
};

/// The face as a segment in the map frame. `room` is the face's room.
Segment segment_in_map(const Room& room, const DoorFace& face);

/// Latched by topoGraph: the space that is being modelled now.
struct CurrentZone {
  std::uint32_t zone_id = 0;
  std::optional<RoomId>
      room;  ///< set once the zone's room is in the graph, or when a known room was entered again
  std::optional<RoomId> from_room;  ///< where the robot came from
  std::optional<DoorId> via_door;
  Pose2 T_map_zone;
  StampNs valid_from_ns = 0;  ///< scans older than this belong to the zone before

  bool operator==(const CurrentZone&) const = default;
};

/// What eq. 18–19 or eq. 20 did to the map → odom transform or to a new room; for people and tests.
struct PoseCorrection {
  enum class Reason : std::uint8_t { kModelDeviation = 0, kCommonDoor = 1 };

  StampNs stamp_ns = 0;
  Reason reason = Reason::kModelDeviation;
  RoomId room = 0;
  Pose2 deviation;   ///< (Δt, Δα) of eq. 18–19, or the shift of the new room by eq. 20
  Pose2 T_map_odom;  ///< as published from now on

  bool operator==(const PoseCorrection&) const = default;
};

}  // namespace enfilade
