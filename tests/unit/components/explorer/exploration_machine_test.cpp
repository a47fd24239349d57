// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/exploration_machine.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/explorer/synthetic_room.hpp"

namespace enfilade::explorer {
namespace {

constexpr double kDt = 0.05;

/// All the others, as simple as can be: a base that does what it is told, a motor that sweeps in two seconds,
/// a detector that always finds the room, a graph that accepts everything.
struct World {
  World() {
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

TEST(ExplorationMachine, FixesTheRoomOnlyAfterAFineSweepThatChangesNothing) {
  World world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kVerifying, 60));
  EXPECT_GE(world.sweeps, 2);
  ASSERT_TRUE(world.run_until(ExplorationPhase::kFixing, 60));
  EXPECT_TRUE(world.said("the room is stable"));
  EXPECT_FALSE(world.moved_while_sweeping);
}

TEST(ExplorationMachine, LeavesThroughTheDoorCentredAndEntersTheNextZone) {
  World world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kEntering, 200));
  world.run_until(ExplorationPhase::kWaiting, 1.0);
  ASSERT_TRUE(world.asked_to_enter);
  EXPECT_EQ(world.asked_to_enter->from_room, 1u);
  EXPECT_EQ(world.asked_to_enter->via_door, 1u);
  EXPECT_NEAR(world.asked_to_enter->T_zone_base.x_m, 4.85, 0.05);
  EXPECT_NEAR(world.asked_to_enter->T_zone_base.y_m, 2.0, 0.05);
  EXPECT_NEAR(world.asked_to_enter->T_zone_base.yaw_rad, 0.0, radians(3));
}

TEST(ExplorationMachine, MarksADoorOntoEmptyGroundAsAnExitAndFinishes) {
  World world;
  world.grid = SyntheticRoom().room(0, 0, 4, 4).solid(4.0, 0, 4.2, 4).free(4.0, 1.5, 8, 2.5, 0.0, 2.0).grid();
  ASSERT_TRUE(world.run_until(ExplorationPhase::kFinished, 300));
  EXPECT_EQ(world.map.doors[0].kind, DoorKind::kExit);
  EXPECT_TRUE(world.said("door 1 opens on empty ground: an exit"));
  EXPECT_TRUE(world.said("no door is left: finished after"));
  EXPECT_LT(world.pose.x_m, 3.7);
}

TEST(ExplorationMachine, MarksADoorThatIsNoWayThroughAsBlocked) {
  World world;
  const auto box = SyntheticRoom().solid(4.3, 1.0, 4.7, 3.0, 0.0, 0.5);
  world.grid.apply(0.05, box.cells());
  ASSERT_TRUE(world.run_until(ExplorationPhase::kFinished, 400));
  EXPECT_EQ(world.map.doors[0].kind, DoorKind::kBlocked);
  EXPECT_TRUE(world.said("trying again what could not be reached, 1 unresolved door"));
}

TEST(ExplorationMachine, ComesBackToADoorThatWasBarredWhenNoOtherIsLeft) {
  World world;
  world.grid.apply(0.05, SyntheticRoom().solid(4.3, 1.0, 4.7, 3.0, 0.0, 0.5).cells());
  for (int i = 0; i < 8000 && !world.said("trying again"); ++i) world.tick();
  ASSERT_TRUE(world.said("trying again"));
  EXPECT_EQ(world.map.doors[0].kind, DoorKind::kUnresolved);
  world.grid.apply(0.05, SyntheticRoom().free(4.3, 1.0, 4.7, 3.0, 0.0, 0.5).cells());
  EXPECT_TRUE(world.run_until(ExplorationPhase::kEntering, 200));
}

TEST(ExplorationMachine, LooksBehindItselfWhereTheWayToADoorIsBarred) {
  World world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kFixing, 200));
  // Someone left a trail in the grid all round the robot.
  const Point2 p = world.pose.translation();
  for (const auto [x, y, w, h] : {std::array{-0.6, -0.6, 1.2, 0.1}, std::array{-0.6, 0.5, 1.2, 0.1},
                                  std::array{-0.6, -0.6, 0.1, 1.2}, std::array{0.5, -0.6, 0.1, 1.2}}) {
    world.grid.apply(
        0.05, SyntheticRoom().solid(p.x() + x, p.y() + y, p.x() + x + w, p.y() + y + h, 0.0, 0.5).cells());
  }
  const double yaw_rad = world.pose.yaw_rad;
  for (int i = 0; i < 400 && !world.said("there is no way to it"); ++i) world.tick();
  ASSERT_TRUE(world.said("there is no way to it"));
  ASSERT_TRUE(world.run_until(ExplorationPhase::kScanning, 60));
  EXPECT_NEAR(std::abs(wrap_to_pi(world.pose.yaw_rad - yaw_rad)), kPi, 0.1);
}

TEST(ExplorationMachine, AnUnstableRoomIsFixedInTheEnd) {
  World world;
  for (int i = 0; i < 20000 && world.machine.state().phase != ExplorationPhase::kFixing; ++i) {
    world.estimate.rectangle.width_m = 4.0 + 0.2 * (world.sweeps % 2);
    world.tick();
  }
  EXPECT_EQ(world.machine.state().phase, ExplorationPhase::kFixing);
  EXPECT_EQ(world.sweeps, 12);
  EXPECT_TRUE(world.said("not stable"));
}

TEST(ExplorationMachine, LooksIntoAGapThatIsWiderThanADoorBeforeItFixesTheRoom) {
  World world;
  world.estimate.doors[0].gap = {.wall = 0, .from_m = 0.9, .to_m = 3.1};
  std::optional<Pose2> nearest;
  for (int i = 0; i < 6000 && world.machine.state().phase != ExplorationPhase::kFixing; ++i) {
    world.tick();
    const bool facing = std::abs(world.pose.yaw_rad) < 0.1;
    if (facing && world.motor.phase == SweepPhase::kSweeping && world.pose.x_m > 3.2) nearest = world.pose;
  }
  EXPECT_EQ(world.machine.state().phase, ExplorationPhase::kFixing);
  EXPECT_TRUE(nearest);
}

TEST(ExplorationMachine, LooksFromInFrontIntoAGapThatMayBeADoorBeforeItFixesTheRoom) {
  World world;
  world.estimate.doors[0].state = DoorState::kPossible;
  bool looked = false;
  for (int i = 0; i < 6000 && world.machine.state().phase != ExplorationPhase::kFixing; ++i) {
    world.tick();
    looked = looked || (world.motor.phase == SweepPhase::kSweeping && std::abs(world.pose.yaw_rad) < 0.1 &&
                        world.pose.x_m > 3.0 && std::abs(world.pose.y_m - 2.0) < 0.3);
  }
  EXPECT_EQ(world.machine.state().phase, ExplorationPhase::kFixing);
  EXPECT_TRUE(looked);
}

TEST(ExplorationMachine, StaysInTheRoomThoughALaterModelSwallowsADoorWithALintel) {
  for (const bool has_lintel : {false, true}) {
    World world;
    world.grid = SyntheticRoom()
                     .room(0, 0, 4, 4)
                     .solid(4.0, 0, 4.2, 4)
                     .free(4.0, 1.5, 4.2, 2.5, 0.0, 2.0)
                     .free(4.2, 0.1, 7.9, 3.9, 0.0)  // the walls of the next room are still unseen
                     .grid();
    if (has_lintel) world.estimate.doors[0].height_m = 2.0;
    double farthest_m = 0.0;
    for (int i = 0; i < 6000 && world.machine.state().phase != ExplorationPhase::kFixing; ++i) {
      if (world.sweeps > 1) {
        world.estimate.rectangle = {0, 4, 2, 8, 4};
        world.estimate.doors.clear();
      }
      world.tick();
      farthest_m = std::max(farthest_m, world.pose.x_m);
    }
    if (has_lintel) {
      EXPECT_LT(farthest_m, 4.0);
    } else {
      EXPECT_GT(farthest_m, 4.3) << "without one it may be a passage between two cupboards";
    }
  }
}

TEST(ExplorationMachine, SaysSoWhereNoRectangleFits) {
  World world;
  world.estimate.found = false;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kStuck, 200));
  EXPECT_TRUE(world.said("no rectangle fits"));
  world.estimate.found = true;  // and it tries again
  EXPECT_TRUE(world.run_until(ExplorationPhase::kFixing, 200));
}

TEST(ExplorationMachine, ANewGridEpochStartsTheZoneAgain) {
  World world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kVerifying, 60));
  world.tag.grid_epoch = 9;
  world.estimate.tag = world.tag;
  world.tick();
  EXPECT_EQ(world.machine.state().sweeps_in_zone, 0u);
  EXPECT_TRUE(world.run_until(ExplorationPhase::kFixing, 100));
}

TEST(ExplorationMachine, RestartedInAKnownRoomItGoesOnWithTheDoors) {
  World world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kApproaching, 100));
  const int before = world.sweeps;
  world.machine = ExplorationMachine(MachineConfig{});
  ASSERT_TRUE(world.run_until(ExplorationPhase::kApproaching, 30));
  EXPECT_EQ(world.sweeps, before + 1);
  EXPECT_TRUE(world.run_until(ExplorationPhase::kEntering, 100));
}

TEST(ExplorationMachine, RestartedBeyondADoorItEntersTheZoneThere) {
  World world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kApproaching, 100));
  world.machine = ExplorationMachine(MachineConfig{});
  world.pose = {4.8, 2.0, 0.0};
  ASSERT_TRUE(world.run_until(ExplorationPhase::kEntering, 30));
  world.run_until(ExplorationPhase::kWaiting, 1.0);
  EXPECT_TRUE(world.asked_to_enter);
}

TEST(ExplorationMachine, SomeoneInTheDoorSendsItBackAndTheDoorIsBlocked) {
  World world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kCrossing, 200));
  for (int i = 0; i < 40; ++i) world.tick();
  // Stands still while the robot faces the door; behind the robot it is free.
  world.points.points = {{0.3F, 0.0F, 0.6F}};
  for (int i = 0; i < 400 && !world.said("going back"); ++i) world.tick();
  ASSERT_TRUE(world.said("going back"));
  world.points.points.clear();
  EXPECT_TRUE(world.run_until(ExplorationPhase::kScanning, 60));
  EXPECT_LT(world.pose.x_m, 3.6);
  EXPECT_FALSE(world.asked_to_enter);
}

}  // namespace
}  // namespace enfilade::explorer
