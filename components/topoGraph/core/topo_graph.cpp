// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/topo_graph.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "components/topoGraph/core/graph_edit.hpp"
#include "components/topoGraph/core/relocate.hpp"

namespace enfilade::topo_graph {

TopoGraph::TopoGraph(const GraphConfig& config, TopoState state)
    : config_(config),
      fixer_(config.fixer, config.tracker),
      changer_(config.changer),
      tracker_(config.tracker),
      minimiser_(config.minimiser, config.fixer.uncertainty),
      localiser_(config.localiser),
      state_(std::move(state)) {
  if (config.remembered_answers < 1)
    throw std::invalid_argument("TopoGraph: remembered_answers must be at least 1");
}

FixRoomOutcome TopoGraph::fix_room(const FixRoomRequest& request, StampNs now_ns) {
  if (const Answer* known = find_answer(state_.session, RequestKind::kFixRoom, request.call)) {
    return {.reply = {request.call, known->accepted, known->message, known->id}};
  }
  FixRoomOutcome outcome = fixer_.fix(state_, request.estimate);
  FixRoomReply& reply = outcome.reply;
  reply.call = request.call;
  if (outcome.fixed) close_loops(outcome);
  accept(now_ns, outcome.fixed,
         {reply.call, RequestKind::kFixRoom, reply.accepted, reply.message, reply.room});
  return outcome;
}

/// Started with a map but without a place in it.
std::optional<PoseCorrection> TopoGraph::locate(const RoomEstimate& estimate) {
  localiser_.take(state_.map, estimate);
  const std::optional<PlaceHypothesis> place = localiser_.place();
  if (!place) return std::nullopt;
  Session& session = state_.session;
  session.zone.located = true;
  session.zone.room = place->room;
  session.odom_boot = estimate.tag.odom_boot;
  session.reference = get_room(state_, place->room).rectangle();
  session.reference_ns = estimate.stamp_ns;
  PoseCorrection correction{
      .stamp_ns = estimate.stamp_ns, .reason = PoseCorrection::Reason::kLocalised, .room = place->room};
  move_zone(place->T_map_zone, correction);
  return correction;
}

/// A door that joins rooms beside the one that the robot came through, or a stored room found again, closes a
/// loop: eq. 20 alone cannot fulfil it, eq. 21 can.
void TopoGraph::close_loops(FixRoomOutcome& outcome) {
  const std::size_t came_through = outcome.common_door ? 1 : 0;
  if (!outcome.covered && outcome.joined_doors.size() <= came_through) return;
  std::vector<DoorId> fresh = outcome.joined_doors;
  std::erase_if(fresh, [this](DoorId door) { return get_door(state_, door).driven; });
  const Minimised minimised = minimiser_.minimise(state_, fresh);
  outcome.minimised = minimised.moved;
  outcome.withdrawn = minimised.withdrawn;
  if (state_.session.zone.room) outcome.reply.room = *state_.session.zone.room;
  if (!outcome.correction) {
    outcome.correction = PoseCorrection{.stamp_ns = state_.session.reference_ns,
                                        .reason = PoseCorrection::Reason::kMinimisation,
                                        .room = outcome.reply.room};
  }
  outcome.correction->T_map_odom = state_.session.zone.T_map_zone;
}

EnterZoneOutcome TopoGraph::enter_zone(const EnterZoneRequest& request, StampNs now_ns) {
  if (const Answer* known = find_answer(state_.session, RequestKind::kEnterZone, request.call)) {
    return {.reply = {request.call, known->accepted, known->message, known->id}};
  }
  EnterZoneOutcome outcome = changer_.enter(state_, request);
  EnterZoneReply& reply = outcome.reply;
  reply.call = request.call;
  accept(now_ns, outcome.joined_by_position,
         {reply.call, RequestKind::kEnterZone, reply.accepted, reply.message, reply.zone_id});
  return outcome;
}

MarkDoorOutcome TopoGraph::mark_door(const MarkDoorRequest& request, StampNs now_ns) {
  if (const Answer* known = find_answer(state_.session, RequestKind::kMarkDoor, request.call)) {
    return {.reply = {request.call, known->accepted, known->message}};
  }
  MarkDoorOutcome outcome = mark(request);
  MarkDoorReply& reply = outcome.reply;
  reply.call = request.call;
  accept(now_ns, outcome.marked, {reply.call, RequestKind::kMarkDoor, reply.accepted, reply.message});
  return outcome;
}

MarkDoorOutcome TopoGraph::mark(const MarkDoorRequest& request) {
  MarkDoorOutcome outcome;
  std::string& why_not = outcome.reply.message;
  const Door* door = state_.map.find_door(request.door);
  if (!door) {
    why_not = "there is no door " + std::to_string(request.door);
  } else if (request.kind == DoorKind::kPassage ||
             (request.kind == DoorKind::kUnresolved && !request.closed)) {
    why_not = "a door can only be marked exit, blocked, closed or open";
  } else if (request.kind == DoorKind::kExit && door->other_face) {
    why_not = "door " + std::to_string(request.door) + " joins two rooms: it is no exit";
  }
  if (!why_not.empty()) return outcome;
  Door marked = *door;
  if (request.kind != DoorKind::kUnresolved) marked.kind = request.kind;
  if (request.closed) marked.closed = *request.closed;
  outcome.marked = !(marked == *door);
  outcome.reply.accepted = true;
  get_door(state_, request.door) = marked;
  return outcome;
}

void TopoGraph::accept(StampNs now_ns, bool changed, Answer answer) {
  remember(state_.session, std::move(answer), static_cast<std::size_t>(config_.remembered_answers));
  if (!changed) return;
  ++state_.map.version;
  state_.map.stamp_ns = now_ns;
}

ObserveOutcome TopoGraph::observe(const RoomEstimate& estimate) {
  Session& session = state_.session;
  ObserveOutcome outcome;
  if (!estimate.found || estimate.tag.zone_id != session.zone.zone_id) return outcome;
  if (!session.zone.located) {
    outcome.correction = locate(estimate);
    return outcome;
  }
  if (!session.odom_boot) session.odom_boot = estimate.tag.odom_boot;
  outcome.odometry_restarted = *session.odom_boot != estimate.tag.odom_boot;
  // A room that is not in the graph yet hangs on the zone's frame, which outlives the odometry.
  if (!session.zone.room) session.odom_boot = estimate.tag.odom_boot;
  if (outcome.odometry_restarted && session.zone.room) {
    outcome.correction = find_room_again(estimate);
    outcome.room_found_again = outcome.correction.has_value();
  } else {
    review(estimate, outcome);
    outcome.correction = track(estimate);
    if (outcome.minimised || outcome.room_withdrawn) {
      if (!outcome.correction)
        outcome.correction =
            PoseCorrection{.stamp_ns = estimate.stamp_ns, .reason = PoseCorrection::Reason::kMinimisation};
      move_zone(session.zone.T_map_zone, *outcome.correction);
    }
  }
  return outcome;
}

/// An inferred door was gone through: the room behind it is what the graph says, or it is not.
void TopoGraph::review(const RoomEstimate& estimate, ObserveOutcome& outcome) {
  const CurrentZone& zone = state_.session.zone;
  const Door* door = zone.via_door ? state_.map.find_door(*zone.via_door) : nullptr;
  if (!zone.room || !door || door->driven || !door->other_face) return;
  if (estimate.unexplored_wall_share > config_.review_unexplored_share) return;
  const auto& closures = state_.session.closures;
  const bool modelled_here =
      std::any_of(closures.begin(), closures.end(), [&](const LoopClosure& c) { return c.door == door->id; });
  if (modelled_here) return;  // this very model was compared when the loop was closed
  const Rectangle room = zone.T_map_zone.inverse() * get_room(state_, *zone.room).rectangle();
  if (tracker_.deviation(room, estimate.rectangle)) return confirm_door(outcome);
  if (++misfits_ < config_.review_misfits) return;
  misfits_ = 0;
  withdraw(state_, door->id);
  state_.session.zone.room.reset();
  state_.session.reference.reset();
  outcome.room_withdrawn = true;
  ++state_.map.version;
}

void TopoGraph::confirm_door(ObserveOutcome& outcome) {
  misfits_ = 0;
  get_door(state_, *state_.session.zone.via_door).driven = true;
  outcome.minimised = minimiser_.minimise(state_, {}).moved;
  ++state_.map.version;
}

std::optional<PoseCorrection> TopoGraph::track(const RoomEstimate& estimate) {
  Session& session = state_.session;
  if (!session.reference) return std::nullopt;
  // The zone in which the room was modelled compares only recent models, as eq. 18–19 ask; in a room entered
  // again the whole grid is recent.
  const Room& room = get_room(state_, *session.zone.room);
  const bool modelled_here = room.zone_id == session.zone.zone_id;
  if (!estimate.recent && modelled_here) return std::nullopt;
  const Rectangle& seen = estimate.recent ? *estimate.recent : estimate.rectangle;
  const StampNs stamp_ns = estimate.recent ? estimate.recent_stamp_ns : estimate.stamp_ns;
  if (stamp_ns <= session.reference_ns) return std::nullopt;

  const Rectangle reference = session.zone.T_map_zone.inverse() * *session.reference;
  const std::optional<Pose2> D = tracker_.deviation(reference, seen);
  if (!D || !tracker_.is_significant(reference, *D)) return std::nullopt;
  session.reference_ns = stamp_ns;
  get_room(state_, room.id).seen_ns = stamp_ns;
  PoseCorrection correction{.stamp_ns = stamp_ns, .room = room.id, .deviation = *D};
  move_zone(session.zone.T_map_zone * D->inverse(), correction);  // T_map_odom ← T_map_odom · D⁻¹
  return correction;
}

std::optional<PoseCorrection> TopoGraph::find_room_again(const RoomEstimate& estimate) {
  Session& session = state_.session;
  if (!session.zone.room) return std::nullopt;
  const Room& room = get_room(state_, *session.zone.room);
  const double max_difference_m = config_.tracker.max_size_difference_m;
  const auto T_map_zone = relocate(state_.map, room, estimate, session.zone.T_map_zone, max_difference_m);
  if (!T_map_zone) return std::nullopt;
  PoseCorrection correction{.stamp_ns = estimate.stamp_ns, .room = room.id};
  correction.deviation = T_map_zone->inverse() * session.zone.T_map_zone;
  move_zone(*T_map_zone, correction);
  session.odom_boot = estimate.tag.odom_boot;
  session.reference = room.rectangle();
  session.reference_ns = estimate.stamp_ns;
  return correction;
}

void TopoGraph::move_zone(const Pose2& T_map_zone, PoseCorrection& correction) {
  state_.session.zone.T_map_zone = T_map_zone;
  correction.T_map_odom = T_map_zone;
}

}  // namespace enfilade::topo_graph
