// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/room_fixer.hpp"

#include <algorithm>
#include <cmath>
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

/// Close enough for gaps of the one to be gaps of the other.
bool is_same_room(const Room& a, const Room& b) {
  constexpr double kSizeM = 0.25, kPlaceM = 0.40;
  return std::abs(a.width_m - b.width_m) <= kSizeM && std::abs(a.height_m - b.height_m) <= kSizeM &&
         (a.T_map_room.translation() - b.T_map_room.translation()).norm() <= kPlaceM &&
         std::abs(wrap_to_pi(a.T_map_room.yaw_rad - b.T_map_room.yaw_rad)) <= radians(10.0);
}

}  // namespace

RoomFixer::RoomFixer(const RoomFixerConfig& config, const PoseTrackerConfig& tracker)
    : config_(config),
      common_door_(config.common_door),
      loop_closer_(config.loop_closer, config.uncertainty),
      tracker_(tracker) {}

FixRoomOutcome RoomFixer::fix(TopoState& state, const RoomEstimate& estimate) const {
  const std::uint32_t current = state.session.zone.zone_id;
  if (const Room* room = find_room_of_zone(state, estimate.tag.zone_id))
    return add_seen_doors(state, *room, estimate);
  if (estimate.tag.zone_id != current) {
    return refused("the estimate is of zone " + std::to_string(estimate.tag.zone_id) +
                   ", the current one is " + std::to_string(current));
  }
  if (!state.session.zone.located) return refused("the robot's place in the map is not known yet");
  if (!estimate.found || estimate.rectangle.width_m <= 0.0 || estimate.rectangle.height_m <= 0.0) {
    return refused("the estimate holds no room");
  }
  return insert(state, estimate);
}

/// The room itself stays as it is.
FixRoomOutcome RoomFixer::add_seen_doors(TopoState& state, const Room& room,
                                         const RoomEstimate& estimate) const {
  FixRoomOutcome outcome = answered(room.id);
  const CurrentZone& zone = state.session.zone;
  if (!zone.located || estimate.tag.zone_id != zone.zone_id || !estimate.found) return outcome;
  const RoomModel model = room_model(estimate, zone.T_map_zone);
  if (!is_same_room(model.room, room)) return outcome;
  outcome.covered = true;
  add_doors(state, model, outcome);
  outcome.covered = false;
  outcome.revisited = outcome.fixed = !outcome.new_doors.empty() || !outcome.joined_doors.empty();
  return outcome;
}

FixRoomOutcome RoomFixer::insert(TopoState& state, const RoomEstimate& estimate) const {
  FixRoomOutcome outcome;
  meet_common_door(state, estimate, outcome);  // eq. 20
  Pose2& T_map_zone = state.session.zone.T_map_zone;
  RoomModel model = room_model(estimate, T_map_zone);  // eq. 17
  const auto same = loop_closer_.find(state.map, predict(state, model, outcome));
  outcome.fixed = true;
  outcome.covered = same.has_value();
  outcome.reply.accepted = true;
  outcome.reply.room = same ? same->room : add_room(state, model, outcome);
  const RoomId id = outcome.reply.room;
  if (same && state.session.zone.via_door && same->room != state.session.zone.from_room)
    state.session.closures.push_back(closure_of(state, model, outcome));
  if (same) {  // the robot is in that room, so both go to where it is
    T_map_zone = same->T_map_model * model.room.T_map_room.inverse() * T_map_zone;
    model.room.T_map_room = same->T_map_model;
  }
  add_doors(state, model, outcome);
  if (outcome.covered && !state.session.closures.empty() && state.session.closures.back().room == id)
    state.session.closures.back().added = outcome.new_doors;
  if (outcome.correction) outcome.correction->room = id;
  state.session.zone.room = id;
  state.session.odom_boot = estimate.tag.odom_boot;
  take_reference(state.session, estimate, same ? state.map.find_room(id) : nullptr);
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

Prediction RoomFixer::predict(const TopoState& state, const RoomModel& model,
                              const FixRoomOutcome& outcome) const {
  const CurrentZone& zone = state.session.zone;
  Prediction prediction{.model = model, .from_room = zone.from_room, .via_door = zone.via_door};
  if (outcome.common_door) prediction.entrance = renamed(outcome.common_door->gap, model.quarter_turns);
  const bool corrected = outcome.common_door && outcome.common_door->corrected;
  const Room* from = zone.from_room ? state.map.find_room(*zone.from_room) : nullptr;
  const double way_m =
      from ? (from->T_map_room.translation() - model.room.T_map_room.translation()).norm() : 5.0;
  prediction.covariance = loop_closer_.step_covariance(way_m, corrected);
  return prediction;
}

/// What odometry says of the new room, before eq. 20 moved it.
RoomLink RoomFixer::link_to(const TopoState& state, const RoomModel& model,
                            const FixRoomOutcome& outcome) const {
  const Room* from = state.map.find_room(*state.session.zone.from_room);
  const Pose2 moved = outcome.common_door ? outcome.common_door->correction : Pose2{};
  RoomLink link{.from = from->id};
  link.T_from_to = from->T_map_room.inverse() * moved.inverse() * model.room.T_map_room;
  link.sigma_position_m = config_.uncertainty.odometry_m +
                          config_.uncertainty.odometry_share * link.T_from_to.translation().norm();
  link.sigma_yaw_rad = config_.uncertainty.odometry_yaw_rad;
  return link;
}

RoomId RoomFixer::add_room(TopoState& state, const RoomModel& model, const FixRoomOutcome& outcome) const {
  Room room = model.room;
  room.seen_ns = room.fixed_ns;
  const Session& session = state.session;
  room.T_room_base =
      room.T_map_room.inverse() * session.zone.T_map_zone * session.T_zone_base.value_or(Pose2{});
  if (!state.map.places.empty()) room.place = state.map.places.back().id;
  std::optional<RoomLink> link;
  if (session.zone.from_room) link = link_to(state, model, outcome);
  const RoomId id = insert_room(state, std::move(room));
  if (link) {
    link->to = id;
    state.map.links.push_back(*link);
  }
  return id;
}

LoopClosure RoomFixer::closure_of(const TopoState& state, const RoomModel& model,
                                  const FixRoomOutcome& outcome) const {
  LoopClosure closure{
      .door = *state.session.zone.via_door, .room = outcome.reply.room, .instead = model.room};
  if (outcome.common_door) closure.entrance = renamed(outcome.common_door->gap, model.quarter_turns);
  closure.link = link_to(state, model, outcome);
  for (const DoorEstimate& door : model.doors)
    if (!(door.gap == closure.entrance)) closure.gaps.push_back(door.gap);
  return closure;
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
    Door& joined = get_door(state, *zone.via_door);
    joined.measured_thickness_m = outcome.common_door->measured_thickness_m;
    joined.driven = !outcome.covered;  // which room lies behind a loop is inferred
    if (!outcome.common_door->seen && joined.other_face->gap == on_wall(*entrance))
      joined.other_face->position_sigma_m = config_.uncertainty.door_unseen_m;
    outcome.joined_doors.push_back(*zone.via_door);
  }
  for (const DoorEstimate& door : model.doors) {
    if (entrance && door.gap == *entrance) continue;
    const DoorEdit edit = add_door(state, id, on_wall(door.gap), door, config_.face_match);
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
