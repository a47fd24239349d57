// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/node/story.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "interfaces/model/counted.hpp"

namespace enfilade::topo_graph {
namespace {

template <class... Values>
std::string print(const char* format, Values... values) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::string name(const char* what, std::uint32_t id) { return std::string(what) + " " + std::to_string(id); }

std::string motion(const PoseCorrection& correction) {
  return print("%.3f m, %.2f°", correction.deviation.translation().norm(),
               degrees(std::abs(correction.deviation.yaw_rad)));
}

std::string doors(const std::vector<DoorId>& ids) {
  std::string text;
  for (const DoorId id : ids) text += (text.empty() ? "" : ", ") + std::to_string(id);
  return (ids.size() == 1 ? "door " : "doors ") + text;
}

std::string tell_common_door(const FixRoomOutcome& outcome) {
  const CommonDoor& door = *outcome.common_door;
  const std::string id =
      outcome.joined_doors.empty() ? "the door" : name("door", outcome.joined_doors.front());
  if (!outcome.correction) return "; too far from " + id + " to be moved to it";
  return "; moved by " + motion(*outcome.correction) + " to meet " + id + " (eq. 20" +
         (door.seen ? "" : ", the door itself not seen from here") +
         print("; wall %.2f m)", door.thickness_m);
}

}  // namespace

std::string tell(const FixRoomOutcome& outcome, const TopologicalMap& map) {
  const RoomId id = outcome.reply.room;
  const Room* room = map.find_room(id);
  std::string text = name("room", id) + (outcome.revisited ? " seen again: "
                                         : outcome.covered ? " found again: "
                                                           : " fixed: ");
  if (room) text += print("%.2f × %.2f m", room->width_m, room->height_m);
  if (outcome.common_door) text += tell_common_door(outcome);
  if (!outcome.joined_doors.empty()) text += "; passage through " + doors(outcome.joined_doors);
  if (outcome.minimised) text += "; loop closed, the whole map minimised (eq. 21)";
  if (!outcome.withdrawn.empty()) text += "; taken back: " + doors(outcome.withdrawn);
  if (!outcome.new_doors.empty()) text += "; new " + doors(outcome.new_doors);
  return text;
}

std::string tell(const EnterZoneOutcome& outcome, const CurrentZone& zone) {
  std::string text = name("zone", zone.zone_id) + " entered through " +
                     name("door", zone.via_door.value_or(0)) + " of " +
                     name("room", zone.from_room.value_or(0));
  if (!zone.room) return text + ": not in the map yet";
  return text + ": this is " + name("room", *zone.room) +
         (outcome.joined_by_position ? ", by its place" : "");
}

std::string tell(const MarkDoorRequest& request) {
  std::string text = name("door", request.door);
  if (request.kind != DoorKind::kUnresolved)
    text += request.kind == DoorKind::kExit ? " leads outside" : " is no way through";
  if (request.closed) text += *request.closed ? " is closed" : " is open";
  return text;
}

std::string tell(const ObserveOutcome& outcome, const TopologicalMap& map) {
  const RoomId id = outcome.correction->room;
  const Room* room = map.find_room(id);
  const std::string of = room ? room->name : name("room", id);
  if (outcome.correction->reason == PoseCorrection::Reason::kLocalised)
    return "found the place in the map: this is " + of;
  if (outcome.room_withdrawn)
    return "this is not the room that the map has here: the door leads to another one";
  if (outcome.room_found_again) return "odometry started anew; " + of + " found again in it";
  return "pose corrected by " + motion(*outcome.correction) + " after " + of + " (eq. 18-19)";
}

std::string tell_resumed(const TopoState& state) {
  return "resumed in " + name("zone", state.session.zone.zone_id) + " with " +
         counted(state.map.rooms.size(), "room") + " and " + counted(state.map.doors.size(), "door");
}

}  // namespace enfilade::topo_graph
