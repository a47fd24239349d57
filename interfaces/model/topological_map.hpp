// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interfaces/model/room.hpp"

namespace enfilade {

using RoomId = std::uint32_t;   ///< from 1; 0 on the wire means "none"
using DoorId = std::uint32_t;   ///< from 1
using PlaceId = std::uint32_t;  ///< from 1; 0 = none

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
  double position_sigma_m = 0.0;  ///< standard deviation of gap.middle_m; 0 = not estimated
  /// From the wall's middle, as measured: what the global minimisation moves `gap` away from. Empty = `gap`.
  std::optional<double> measured_offset_m;

  bool operator==(const DoorFace&) const = default;
};

/// An edge of the graph. The first face belongs to the room from which the door was first seen.
struct Door {
  DoorId id = 0;
  DoorKind kind = DoorKind::kUnresolved;
  DoorFace face;
  std::optional<DoorFace> other_face;
  std::optional<double> height_m;
  std::optional<double> thickness_m;  ///< of the wall between the faces, where both are known; ≥ 0
  /// As measured when the robot went through: what the global minimisation moves `thickness_m` away from.
  std::optional<double> measured_thickness_m;
  bool driven =
      false;  ///< the robot has gone through: certain, while a door that only seems to join may be wrong
  bool closed = false;  ///< marked as shut for the time being: not on any route

  bool operator==(const Door&) const = default;
};

/// A node of the graph.
struct Room {
  RoomId id = 0;
  std::string name;
  Pose2 T_map_room;  ///< the paper's T_r (eq. 17)
  double width_m = 0.0;
  double height_m = 0.0;
  std::optional<Point2> measured_size_m;  ///< what the global minimisation moves the size away from
  std::optional<RectangleCovariance> covariance;
  std::vector<Point2> polygon;  ///< room frame; empty = the rectangle itself
  std::uint32_t zone_id = 0;    ///< the zone it was modelled in
  StampNs fixed_ns = 0;
  StampNs seen_ns = 0;               ///< when an estimate last agreed with it
  std::optional<Pose2> T_room_base;  ///< from where it was modelled: the robot's pose in the room
  PlaceId place = 0;                 ///< the floor it is on

  Rectangle rectangle() const {
    return {T_map_room.yaw_rad, T_map_room.x_m, T_map_room.y_m, width_m, height_m};
  }
  bool operator==(const Room&) const = default;
};

enum class PlaceKind : std::uint8_t { kBuilding = 0, kFloor = 1 };

/// A node that holds a graph of its own (section II): a building holds floors, a floor holds rooms.
struct Place {
  PlaceId id = 0;
  PlaceId parent = 0;  ///< 0 = the top
  PlaceKind kind = PlaceKind::kFloor;
  std::string name;

  bool operator==(const Place&) const = default;
};

/// What odometry measured from one room's frame to the next one's, with its standard deviations.
struct RoomLink {
  RoomId from = 0;
  RoomId to = 0;
  Pose2 T_from_to;
  double sigma_position_m = 0.0;
  double sigma_yaw_rad = 0.0;

  bool operator==(const RoomLink&) const = default;
};

struct TopologicalMap {
  std::uint64_t version = 0;  ///< grows with every accepted change
  StampNs stamp_ns = 0;
  std::vector<Room> rooms;      ///< by id
  std::vector<Door> doors;      ///< by id
  std::vector<RoomLink> links;  ///< in the order of driving
  std::vector<Place> places;    ///< by id, parents first

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
  bool located = true;        ///< false: started with a map but no pose, and T_map_zone means nothing yet
  StampNs valid_from_ns = 0;  ///< scans older than this belong to the zone before

  bool operator==(const CurrentZone&) const = default;
};

/// What eq. 18–19, eq. 20, eq. 21 or finding the place in a saved map did to the map → odom transform or to a
/// new room; for people and tests.
struct PoseCorrection {
  enum class Reason : std::uint8_t {
    kModelDeviation = 0,
    kCommonDoor = 1,
    kMinimisation = 2,
    kLocalised = 3
  };

  StampNs stamp_ns = 0;
  Reason reason = Reason::kModelDeviation;
  RoomId room = 0;
  Pose2 deviation;   ///< (Δt, Δα) of eq. 18–19, or the shift of the new room by eq. 20
  Pose2 T_map_odom;  ///< as published from now on

  bool operator==(const PoseCorrection&) const = default;
};

}  // namespace enfilade
