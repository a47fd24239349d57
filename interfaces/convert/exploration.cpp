// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/room.hpp"

namespace enfilade::wire {

own::CurrentZone_ to_wire(const CurrentZone& zone) {
  own::CurrentZone_ out;
  out.zone_id(zone.zone_id);
  out.has_room(zone.room.has_value());
  out.room(zone.room.value_or(0));
  out.has_from_room(zone.from_room.has_value());
  out.from_room(zone.from_room.value_or(0));
  out.has_via_door(zone.via_door.has_value());
  out.via_door(zone.via_door.value_or(0));
  out.pose_map_zone(to_wire(zone.T_map_zone));
  out.located(zone.located);
  out.valid_from_ns(zone.valid_from_ns);
  return out;
}

CurrentZone from_wire(const own::CurrentZone_& zone) {
  return {.zone_id = zone.zone_id(),
          .room = optional_from_wire(zone.has_room(), zone.room()),
          .from_room = optional_from_wire(zone.has_from_room(), zone.from_room()),
          .via_door = optional_from_wire(zone.has_via_door(), zone.via_door()),
          .T_map_zone = from_wire(zone.pose_map_zone()),
          .located = zone.located(),
          .valid_from_ns = zone.valid_from_ns()};
}

own::PoseCorrection_ to_wire(const PoseCorrection& correction) {
  own::PoseCorrection_ out;
  out.stamp_ns(correction.stamp_ns);
  out.reason(enum_to_wire(correction.reason));
  out.room(correction.room);
  out.deviation(to_wire(correction.deviation));
  out.pose_map_odom(to_wire(correction.T_map_odom));
  return out;
}

PoseCorrection from_wire(const own::PoseCorrection_& correction) {
  using Reason = PoseCorrection::Reason;
  return {correction.stamp_ns(),
          enum_from_wire(correction.reason(), Reason::kLocalised, "the reason of a correction"),
          correction.room(), from_wire(correction.deviation()), from_wire(correction.pose_map_odom())};
}

own::ExplorationState_ to_wire(const ExplorationState& state) {
  own::ExplorationState_ out;
  out.tag(to_wire(state.tag));
  out.stamp_ns(state.stamp_ns);
  out.phase(enum_to_wire(state.phase));
  out.activity(state.activity);
  out.sweeps_in_zone(state.sweeps_in_zone);
  out.sweeps_total(state.sweeps_total);
  out.unexplored_wall_share(state.unexplored_wall_share);
  out.has_room(state.room.has_value());
  out.room(state.room.value_or(0));
  out.has_target_door(state.target_door.has_value());
  out.target_door(state.target_door.value_or(0));
  out.has_goal(state.goal.has_value());
  out.goal(to_wire(state.goal.value_or(Pose2{})));
  return out;
}

ExplorationState from_wire(const own::ExplorationState_& state) {
  return {.tag = from_wire(state.tag()),
          .stamp_ns = state.stamp_ns(),
          .phase = enum_from_wire(state.phase(), ExplorationPhase::kStuck, "the phase of an exploration"),
          .activity = checked(state.activity()),
          .sweeps_in_zone = state.sweeps_in_zone(),
          .sweeps_total = state.sweeps_total(),
          .unexplored_wall_share = state.unexplored_wall_share(),
          .room = optional_from_wire(state.has_room(), state.room()),
          .target_door = optional_from_wire(state.has_target_door(), state.target_door()),
          .goal = optional_from_wire(state.has_goal(), from_wire(state.goal()))};
}

}  // namespace enfilade::wire
