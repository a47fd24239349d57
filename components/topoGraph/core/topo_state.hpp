// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interfaces/model/requests.hpp"
#include "interfaces/model/topological_map.hpp"

namespace enfilade::topo_graph {

enum class RequestKind : std::uint8_t { kFixRoom = 0, kEnterZone = 1, kMarkDoor = 2 };

/// What one call was answered, so that a repeated call gets the same answer, also after a restart.
struct Answer {
  CallId call;
  RequestKind kind = RequestKind::kFixRoom;
  bool accepted = false;
  std::string message;
  std::uint32_t id = 0;  ///< the room of kFixRoom, the zone of kEnterZone

  bool operator==(const Answer&) const = default;
};

/// A room that was taken for a stored one, and what has to be known to take that back.
struct LoopClosure {
  DoorId door = 0;                 ///< through which the robot came
  RoomId room = 0;                 ///< the stored room
  Room instead;                    ///< the room as it was modelled anew, without an id, at `link.T_from_to`
  RoomLink link;                   ///< `to` is 0
  WallInterval entrance;           ///< in the walls of `instead`
  std::vector<WallInterval> gaps;  ///< its other open gaps
  std::vector<DoorId> added;       ///< doors that this visit gave the stored room

  bool operator==(const LoopClosure&) const = default;
};

/// Where the exploration stands: what a restarted topoGraph needs beside the map to go on as if nothing had
/// happened.
struct Session {
  CurrentZone zone;
  /// r(i) of eq. 18–19 in the map frame: where a new estimate of the zone's room must lie. It stays where it
  /// is while T_map_zone follows the odometry; empty while the zone's room is not in the graph.
  std::optional<Rectangle> reference;
  StampNs reference_ns = 0;  ///< of the newest estimate compared with it
  std::optional<std::uint32_t> odom_boot;
  std::optional<Pose2> T_zone_base;   ///< where the zone was entered
  std::vector<LoopClosure> closures;  ///< oldest first
  RoomId last_room = 0;               ///< ids are never used twice
  DoorId last_door = 0;
  std::vector<Answer> answers;  ///< oldest first

  bool operator==(const Session&) const = default;
};

/// All that TopoGraph knows; a value, so that a change which could not be stored is undone by putting the old
/// one back.
struct TopoState {
  TopologicalMap map;
  Session session;

  bool operator==(const TopoState&) const = default;
};

/// The state before anything is known: zone 1, whose frame is the map's.
TopoState first_state(StampNs now_ns);

/// A new zone in a map that is kept, with no idea where in it: a room must be recognised first.
TopoState lost_state(TopologicalMap map, const Session& before, StampNs now_ns);

const Answer* find_answer(const Session& session, RequestKind kind, const CallId& call);

/// Keeps the newest `capacity` answers.
void remember(Session& session, Answer answer, std::size_t capacity);

}  // namespace enfilade::topo_graph
