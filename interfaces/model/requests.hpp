// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interfaces/model/grid.hpp"
#include "interfaces/model/route.hpp"
#include "interfaces/model/topological_map.hpp"

namespace enfilade {

/// Ties a reply to its request: `client` is unique to one run of one component, `number` counts its calls. A
/// repeated request carries the same id and gets the same answer.
struct CallId {
  std::string client;
  std::uint64_t number = 0;

  bool operator==(const CallId&) const = default;
  auto operator<=>(const CallId&) const = default;
};

/// explorer → topoGraph: the model of this zone's room is stable; put it into the graph (eq. 20 against the
/// common door).
struct FixRoomRequest {
  CallId call;
  RoomEstimate estimate;

  bool operator==(const FixRoomRequest&) const = default;
};

struct FixRoomReply {
  CallId call;
  bool accepted = false;
  std::string message;  ///< why not
  RoomId room = 0;

  bool operator==(const FixRoomReply&) const = default;
};

/// explorer → topoGraph: the robot has crossed `via_door` and stands still at `T_zone_base` of the zone it
/// leaves.
struct EnterZoneRequest {
  CallId call;
  RoomId from_room = 0;
  DoorId via_door = 0;
  Pose2 T_zone_base;
  StampNs stamp_ns = 0;

  bool operator==(const EnterZoneRequest&) const = default;
};

struct EnterZoneReply {
  CallId call;
  bool accepted = false;
  std::string message;
  std::uint32_t zone_id = 0;

  bool operator==(const EnterZoneReply&) const = default;
};

/// explorer → topoGraph: what a closer look at a door has shown (an exit, or no way through); anybody →
/// topoGraph: whether it is closed for the time being.
struct MarkDoorRequest {
  CallId call;
  DoorId door = 0;
  DoorKind kind = DoorKind::kUnresolved;  ///< kUnresolved leaves it as it is
  std::optional<bool> closed = {};

  bool operator==(const MarkDoorRequest&) const = default;
};

struct MarkDoorReply {
  CallId call;
  bool accepted = false;
  std::string message;

  bool operator==(const MarkDoorReply&) const = default;
};

/// anybody → topoGraph: the shortest way from door to door. A place with room 0 is a point of the map, one
/// with a room is the middle of it.
struct RouteRequest {
  CallId call;
  RoutePlace start;
  RoutePlace goal;
  std::vector<DoorId> closed_doors;  ///< beside those that the map knows to be closed

  bool operator==(const RouteRequest&) const = default;
};

struct RouteReply {
  CallId call;
  bool found = false;
  std::string message;  ///< why there is none
  Route route;

  bool operator==(const RouteReply&) const = default;
};

/// roomDetector, explorer → gridBuilder: all cells of the current epoch.
struct GridSnapshotRequest {
  CallId call;

  bool operator==(const GridSnapshotRequest&) const = default;
};

struct GridSnapshotReply {
  CallId call;
  GridChange snapshot;

  bool operator==(const GridSnapshotReply&) const = default;
};

}  // namespace enfilade
