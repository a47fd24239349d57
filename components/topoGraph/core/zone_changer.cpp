// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/zone_changer.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "components/topoGraph/core/graph_edit.hpp"

namespace enfilade::topo_graph {
namespace {

std::string why_impossible(const TopoState& state, const EnterZoneRequest& request) {
  const Door* door = state.map.find_door(request.via_door);
  const std::string door_name = "door " + std::to_string(request.via_door);
  const std::string room_name = "room " + std::to_string(request.from_room);
  if (!door) return "there is no " + door_name;
  if (!TopologicalMap::find_face(*door, request.from_room)) return door_name + " is no door of " + room_name;
  if (state.session.zone.room != request.from_room) return "the robot is not in " + room_name;
  return {};
}

}  // namespace

ZoneChanger::ZoneChanger(const ZoneChangerConfig& config) : config_(config) {
  if (config.inside_room_m < 0.0)
    throw std::invalid_argument("ZoneChanger: inside_room_m must not be negative");
}

EnterZoneOutcome ZoneChanger::enter(TopoState& state, const EnterZoneRequest& request) const {
  EnterZoneOutcome outcome;
  outcome.reply.message = why_impossible(state, request);
  if (!outcome.reply.message.empty()) return outcome;

  const std::optional<RoomId> room = room_behind(state, request, outcome);
  Session& session = state.session;
  CurrentZone next{.zone_id = session.zone.zone_id + 1, .room = room, .from_room = request.from_room};
  next.via_door = request.via_door;
  next.T_map_zone =
      session.zone.T_map_zone;  // a zone's frame is odom: only the corrections so far carry over
  next.valid_from_ns = request.stamp_ns;
  session.zone = next;
  session.T_zone_base = request.T_zone_base;
  session.reference.reset();
  session.reference_ns = request.stamp_ns;
  if (room) session.reference = get_room(state, *room).rectangle();
  outcome.entered = true;
  outcome.reply.accepted = true;
  outcome.reply.zone_id = next.zone_id;
  return outcome;
}

std::optional<RoomId> ZoneChanger::room_behind(TopoState& state, const EnterZoneRequest& request,
                                               EnterZoneOutcome& outcome) const {
  const Door& door = get_door(state, request.via_door);
  if (door.other_face) return door.face.room == request.from_room ? door.other_face->room : door.face.room;

  const Point2 robot = (state.session.zone.T_map_zone * request.T_zone_base).translation();
  const std::optional<RoomId> room = find_room_at(state.map, robot, request.from_room, config_.inside_room_m);
  if (!room) return std::nullopt;
  const PlacedFace face = place(get_room(state, request.from_room), door.face);
  const Rectangle rectangle = get_room(state, *room).rectangle();
  const WallInterval gap = project_on_nearest_wall(face, rectangle, config_.face_match.max_angle_rad);
  join_door(state, request.via_door, *room, gap, config_.face_match);
  outcome.joined_by_position = true;
  return room;
}

}  // namespace enfilade::topo_graph
