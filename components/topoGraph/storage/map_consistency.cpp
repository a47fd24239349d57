// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_consistency.hpp"

namespace enfilade::topo_graph {
namespace {

using Problem = std::optional<std::string>;

constexpr double kWallSlackM = 1e-6;

Problem missing_room(RoomId id, const TopologicalMap& map) {
  if (map.find_room(id)) return std::nullopt;
  return "there is no room " + std::to_string(id);
}

Problem missing_door(DoorId id, const TopologicalMap& map) {
  if (map.find_door(id)) return std::nullopt;
  return "there is no door " + std::to_string(id);
}

Problem door_problem(const Door& door, const TopologicalMap& map) {
  Problem problem = problem_of(door.face, map);
  if (!problem && door.other_face) problem = problem_of(*door.other_face, map);
  if (problem) *problem = "door " + std::to_string(door.id) + ": " + *problem;
  return problem;
}

Problem closure_problem(const LoopClosure& closure, const TopologicalMap& map) {
  if (auto problem = missing_door(closure.door, map)) return problem;
  if (auto problem = missing_room(closure.room, map)) return problem;
  return missing_room(closure.link.from, map);
}

Problem session_problem(const Session& session, const TopologicalMap& map) {
  const CurrentZone& zone = session.zone;
  for (const auto& room : {zone.room, zone.from_room})
    if (auto problem = room ? missing_room(*room, map) : std::nullopt) return problem;
  if (auto problem = zone.via_door ? missing_door(*zone.via_door, map) : std::nullopt) return problem;
  for (const LoopClosure& closure : session.closures)
    if (auto problem = closure_problem(closure, map)) return problem;
  if (!map.rooms.empty() && session.last_room < map.rooms.back().id)
    return "last_room is less than an id in use";
  if (!map.doors.empty() && session.last_door < map.doors.back().id)
    return "last_door is less than an id in use";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> problem_of(const DoorFace& face, const TopologicalMap& map) {
  const Room* room = map.find_room(face.room);
  if (!room) return missing_room(face.room, map);
  const double length_m = room->rectangle().wall_length_m(face.gap.wall);
  const bool on_wall = face.gap.from_m >= -kWallSlackM && face.gap.from_m < face.gap.to_m &&
                       face.gap.to_m <= length_m + kWallSlackM;
  if (on_wall) return std::nullopt;
  return "the gap does not lie on its wall, which is " + std::to_string(length_m) + " m long";
}

std::optional<std::string> find_contradiction(const MapFile& file) {
  for (const Door& door : file.map.doors)
    if (auto problem = door_problem(door, file.map)) return problem;
  for (const RoomLink& link : file.map.links)
    for (const RoomId room : {link.from, link.to})
      if (auto problem = missing_room(room, file.map)) return problem;
  return file.session ? session_problem(*file.session, file.map) : std::nullopt;
}

}  // namespace enfilade::topo_graph
