// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/graph_route.hpp"

#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace enfilade::explorer {
namespace {

/// Standing at a door, seen from one of its rooms.
struct Stop {
  double length_m = 0.0;
  DoorId door = 0;
  RoomId room = 0;
  DoorId first = 0;  ///< the door by which the present room was left

  auto operator<=>(const Stop&) const = default;
};

Point2 middle_in_map(const Room& room, const DoorFace& face) { return segment_in_map(room, face).midpoint(); }

using Queue = std::priority_queue<Stop, std::vector<Stop>, std::greater<>>;

/// Adds the doors of `room`, as far away as they are from `at`.
void add_doors(const TopologicalMap& map, RoomId room_id, const Point2& at, const Stop& before,
               const std::set<DoorId>& avoid, Queue& open) {
  const Room* room = map.find_room(room_id);
  if (!room) return;
  for (const Door& door : map.doors) {
    const DoorFace* face = TopologicalMap::find_face(door, room_id);
    const bool usable = door.kind == DoorKind::kPassage || door.kind == DoorKind::kUnresolved;
    if (!face || !usable || door.closed || avoid.contains(door.id)) continue;
    const double length_m = before.length_m + (middle_in_map(*room, *face) - at).norm();
    open.push({length_m, door.id, room_id, before.first == 0 ? door.id : before.first});
  }
}

}  // namespace

std::optional<DoorRoute> find_route(const TopologicalMap& map, RoomId room, const Point2& robot_map,
                                    const std::set<DoorId>& avoid) {
  Queue open;
  std::set<std::pair<DoorId, RoomId>> done;
  add_doors(map, room, robot_map, {}, avoid, open);
  while (!open.empty()) {
    const Stop stop = open.top();
    open.pop();
    const Door& door = *map.find_door(stop.door);
    if (door.kind == DoorKind::kUnresolved) return DoorRoute{stop.first, stop.door, stop.length_m};
    if (!door.other_face || !done.emplace(stop.door, stop.room).second) continue;
    const DoorFace& behind = door.face.room == stop.room ? *door.other_face : door.face;
    const Room* next = map.find_room(behind.room);
    if (next) add_doors(map, behind.room, middle_in_map(*next, behind), stop, avoid, open);
  }
  return std::nullopt;
}

}  // namespace enfilade::explorer
