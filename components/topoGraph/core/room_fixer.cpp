// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/room_fixer.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "components/topoGraph/core/graph_edit.hpp"

namespace enfilade::topo_graph {
namespace {

FixRoomOutcome answered(RoomId room) { return {.reply = {.accepted = true, .room = room}}; }
FixRoomOutcome refused(std::string why) { return {.reply = {.message = std::move(why)}}; }

const Room* find_room_of_zone(const TopoState& state, std::uint32_t zone_id) {
  const CurrentZone& zone = state.session.zone;
  if (zone_id == zone.zone_id) return zone.room ? state.map.find_room(*zone.room) : nullptr;
  const auto it = std::find_if(state.map.rooms.begin(), state.map.rooms.end(),
                               [zone_id](const Room& room) { return room.zone_id == zone_id; });
  return it == state.map.rooms.end() ? nullptr : &*it;
}

/// The face, in the room left behind, of the door through which the robot came into this zone.
const DoorFace* find_entrance(const TopoState& state) {
  const CurrentZone& zone = state.session.zone;
  const Door* door = zone.via_door ? state.map.find_door(*zone.via_door) : nullptr;
  return door && zone.from_room ? TopologicalMap::find_face(*door, *zone.from_room) : nullptr;
}

}  // namespace

RoomFixer::RoomFixer(const RoomFixerConfig& config, const PoseTrackerConfig& tracker)
    : config_(config), common_door_(config.common_door), tracker_(tracker) {
  if (config.same_room_iou <= 0.0 || config.same_room_iou > 1.0) {
    throw std::invalid_argument("RoomFixer: same_room_iou must be in (0, 1]");
  }
}

FixRoomOutcome RoomFixer::fix(TopoState& state, const RoomEstimate& estimate) const {
  const std::uint32_t current = state.session.zone.zone_id;
  if (const Room* room = find_room_of_zone(state, estimate.tag.zone_id)) return answered(room->id);
  if (estimate.tag.zone_id != current) {
    return refused("the estimate is of zone " + std::to_string(estimate.tag.zone_id) +
                   ", the current one is " + std::to_string(current));
  }
  if (!estimate.found || estimate.rectangle.width_m <= 0.0 || estimate.rectangle.height_m <= 0.0) {
    return refused("the estimate holds no room");
  }
  return insert(state, estimate);
}

FixRoomOutcome RoomFixer::insert(TopoState& state, const RoomEstimate& estimate) const {
  FixRoomOutcome outcome;
  meet_common_door(state, estimate, outcome);                                   // eq. 20
  const RoomModel model = room_model(estimate, state.session.zone.T_map_zone);  // eq. 17
  const auto covered = find_covered_room(state.map, model.room.rectangle(), config_.same_room_iou);
  const RoomId id = covered ? *covered : insert_room(state, model.room);
  outcome.fixed = true;
  outcome.covered = covered.has_value();
  outcome.reply.accepted = true;
  outcome.reply.room = id;
  add_doors(state, model, outcome);
  if (outcome.correction) outcome.correction->room = id;
  state.session.zone.room = id;
  state.session.odom_boot = estimate.tag.odom_boot;
  take_reference(state.session, estimate, covered ? state.map.find_room(id) : nullptr);
  return outcome;
}

void RoomFixer::meet_common_door(TopoState& state, const RoomEstimate& estimate,
                                 FixRoomOutcome& outcome) const {
  const DoorFace* entrance = find_entrance(state);
  if (!entrance) return;
  Pose2& T_map_zone = state.session.zone.T_map_zone;
  const PlacedFace known = place(get_room(state, entrance->room), *entrance);
  const Pose2 before = T_map_zone * estimate.rectangle.pose();
  outcome.common_door = common_door_.solve(known, T_map_zone * estimate.rectangle, estimate.doors);
  if (!outcome.common_door->corrected) return;
  T_map_zone = outcome.common_door->correction * T_map_zone;  // robot and room move together
  const Pose2 after = T_map_zone * estimate.rectangle.pose();
  outcome.correction =
      PoseCorrection{.stamp_ns = estimate.stamp_ns, .reason = PoseCorrection::Reason::kCommonDoor};
  outcome.correction->deviation = {after.x_m - before.x_m, after.y_m - before.y_m,
                                   wrap_to_pi(after.yaw_rad - before.yaw_rad)};
  outcome.correction->T_map_odom = T_map_zone;
}

void RoomFixer::add_doors(TopoState& state, const RoomModel& model, FixRoomOutcome& outcome) const {
  const RoomId id = outcome.reply.room;
  const Rectangle rectangle = get_room(state, id).rectangle();
  // The walls of a room that was there already are not quite those of the new model: its gaps are moved onto
  // them.
  const auto on_wall = [&](const WallInterval& gap) {
    if (!outcome.covered) return gap;
    const PlacedFace face = place(model.room.rectangle(), gap);
    return project_on_nearest_wall({face.segment, -face.normal}, rectangle, config_.face_match.max_angle_rad);
  };
  const CurrentZone& zone = state.session.zone;
  std::optional<WallInterval> entrance;
  if (outcome.common_door && id != *zone.from_room) {
    entrance = renamed(outcome.common_door->gap, model.quarter_turns);
    join_door(state, *zone.via_door, id, on_wall(*entrance), config_.face_match);
    outcome.joined_doors.push_back(*zone.via_door);
  }
  for (const DoorEstimate& door : model.doors) {
    if (entrance && door.gap == *entrance) continue;
    const DoorEdit edit = add_door(state, id, on_wall(door.gap), door.height_m, config_.face_match);
    if (edit.added) outcome.new_doors.push_back(edit.door);
    if (edit.joined) outcome.joined_doors.push_back(edit.door);
  }
}

/// From now on eq. 18–19 compare models from recent scans with `reference`, so that has to be such a model
/// too: the rectangle from all scans differs from it by the bias of either fit, which would be taken for a
/// motion of the robot. A room that was there already is where it is: there the difference is the robot's
/// error.
void RoomFixer::take_reference(Session& session, const RoomEstimate& estimate, const Room* covered) const {
  const bool usable = estimate.recent && tracker_.deviation(estimate.rectangle, *estimate.recent);
  const Rectangle& seen = usable ? *estimate.recent : estimate.rectangle;
  session.reference = covered ? covered->rectangle() : session.zone.T_map_zone * seen;
  session.reference_ns = usable && !covered ? estimate.recent_stamp_ns : estimate.stamp_ns;
}

}  // namespace enfilade::topo_graph
