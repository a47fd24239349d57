// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "components/explorer/core/exploration_machine.hpp"
#include "tests/unit/components/explorer/synthetic_room.hpp"

namespace enfilade::explorer {

inline constexpr double kDt = 0.05;

/// All the others, as simple as can be: a base that does what it is told, a motor that sweeps in two seconds,
/// a detector that always finds the room, a graph that accepts everything.
struct MachineWorld {
  MachineWorld() {
    grid = SyntheticRoom()
               .room(0, 0, 4, 4)
               .solid(4.0, 0, 4.2, 4)
               .free(4.0, 1.5, 4.2, 2.5, 0.0, 2.0)
               .free(4.2, -1, 8, 5, 0.0)
               .solid(8, -1, 8.05, 5)
               .grid();
    motor.odom_boot = 5;
    tag = {1, 1, 5};
    zone = {.zone_id = 1};
    estimate = {.tag = tag, .found = true, .rectangle = {0, 2, 2, 4, 4}};
    estimate.doors = {{.gap = {.wall = 0, .from_m = 1.5, .to_m = 2.5}, .state = DoorState::kOpen}};
  }

  /// Runs until the phase is `phase`; false if it does not come within `timeout_s`.
  bool run_until(ExplorationPhase phase, double timeout_s) {
    for (const double end_s = now_s + timeout_s; now_s < end_s;) {
      tick();
      if (machine.state().phase == phase) return true;
    }
    return false;
  }

  void tick() {
    now_s += kDt;
    Observation seen{.now_ns = from_seconds(now_s),
                     .T_zone_base = pose,
                     .pose_stamp_ns = from_seconds(now_s),
                     .speed = speed,
                     .motor = &motor,
                     .zone = &zone,
                     .map = &map,
                     .estimate = &estimate,
                     .grid_tag = tag,
                     .grid = &grid,
                     .points = &points};
    if (fixed) seen.fixed = &*fixed;
    if (entered) seen.entered = &*entered;
    if (marked) seen.marked = &*marked;
    const Decision decision = machine.update(seen);
    fixed.reset(), entered.reset(), marked.reset();
    events.insert(events.end(), decision.events.begin(), decision.events.end());
    events.insert(events.end(), decision.warnings.begin(), decision.warnings.end());
    move(decision);
    sweep(decision);
    if (answers) answer(decision);
  }

  void move(const Decision& decision) {
    const bool sweeping = motor.phase == SweepPhase::kSweeping;
    speed = decision.drives ? decision.velocity : VelocityCommand{};
    motor.base_moving = speed != VelocityCommand{};
    moved_while_sweeping |= sweeping && motor.base_moving;
    pose = pose * Pose2{kDt * speed.linear_m_s, 0.0, kDt * speed.angular_rad_s};
    speed = {};
  }

  void sweep(const Decision& decision) {
    if (decision.sweep) {
      motor.sweep_id = decision.sweep->sweep_id;
      const bool park = decision.sweep->action == SweepAction::kPark;
      motor.phase = park ? SweepPhase::kParked : SweepPhase::kSweeping;
      swept_until_s = now_s + 2.0;
      if (!park) ++sweeps;
    }
    if (motor.phase == SweepPhase::kSweeping && now_s >= swept_until_s) {
      motor.phase = SweepPhase::kDone;
      motor.sweep_end_ns = from_seconds(now_s);
      estimate.stamp_ns = motor.sweep_end_ns;
    }
  }

  void answer(const Decision& decision) {
    if (decision.fix_room) {
      fixed = FixRoomReply{.accepted = true, .room = 1};
      zone.room = 1;
      const Rectangle& r = decision.fix_room->estimate.rectangle;
      map.rooms = {
          {.id = 1, .T_map_room = r.pose(), .width_m = r.width_m, .height_m = r.height_m, .zone_id = 1}};
      map.doors.clear();
      for (const DoorEstimate& d : decision.fix_room->estimate.doors) {
        map.doors.push_back({.id = static_cast<DoorId>(map.doors.size() + 1), .face = {1, d.gap}});
      }
    }
    if (decision.mark_door) {
      marked = MarkDoorReply{.accepted = true};
      map.doors[decision.mark_door->door - 1].kind = decision.mark_door->kind;
    }
    if (decision.enter_zone) {
      asked_to_enter = decision.enter_zone;
      entered = EnterZoneReply{.accepted = true, .zone_id = 2};
      zone = {.zone_id = 2, .from_room = 1, .via_door = decision.enter_zone->via_door};
      tag.zone_id = 2, tag.grid_epoch = 2;
    }
  }

  bool said(const std::string& text) const {
    return std::any_of(events.begin(), events.end(),
                       [&](const std::string& e) { return e.find(text) != std::string::npos; });
  }

  ExplorationMachine machine{MachineConfig{}};
  double now_s = 0.0;
  Pose2 pose{1.0, 1.5, 0.3};
  VelocityCommand speed;
  MotorState motor;
  CurrentZone zone;
  TopologicalMap map;
  RoomEstimate estimate;
  ZoneTag tag;
  ProjectedGrid grid{ProjectedGridConfig{}};
  PointCloud points;
  std::optional<FixRoomReply> fixed;
  std::optional<EnterZoneReply> entered;
  std::optional<MarkDoorReply> marked;
  std::optional<EnterZoneRequest> asked_to_enter;
  std::vector<std::string> events;
  double swept_until_s = 0.0;
  int sweeps = 0;
  bool answers = true;
  bool moved_while_sweeping = false;
};

}  // namespace enfilade::explorer
