// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/components/explorer/machine_world.hpp"

namespace enfilade::explorer {
namespace {

TEST(ExplorationDoors, LeavesThroughTheDoorCentredAndEntersTheNextZone) {
  MachineWorld world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kEntering, 200));
  world.run_until(ExplorationPhase::kWaiting, 1.0);
  ASSERT_TRUE(world.asked_to_enter);
  EXPECT_EQ(world.asked_to_enter->from_room, 1u);
  EXPECT_EQ(world.asked_to_enter->via_door, 1u);
  EXPECT_NEAR(world.asked_to_enter->T_zone_base.x_m, 4.85, 0.05);
  EXPECT_NEAR(world.asked_to_enter->T_zone_base.y_m, 2.0, 0.05);
  EXPECT_NEAR(world.asked_to_enter->T_zone_base.yaw_rad, 0.0, radians(3));
}

TEST(ExplorationDoors, MarksADoorOntoEmptyGroundAsAnExitAndFinishes) {
  MachineWorld world;
  world.grid = SyntheticRoom().room(0, 0, 4, 4).solid(4.0, 0, 4.2, 4).free(4.0, 1.5, 8, 2.5, 0.0, 2.0).grid();
  ASSERT_TRUE(world.run_until(ExplorationPhase::kFinished, 300));
  EXPECT_EQ(world.map.doors[0].kind, DoorKind::kExit);
  EXPECT_TRUE(world.said("door 1 opens on empty ground: an exit"));
  EXPECT_TRUE(world.said("no door is left: finished after"));
  EXPECT_LT(world.pose.x_m, 3.7);
}

TEST(ExplorationDoors, MarksADoorThatIsNoWayThroughAsBlocked) {
  MachineWorld world;
  const auto box = SyntheticRoom().solid(4.3, 1.0, 4.7, 3.0, 0.0, 0.5);
  world.grid.apply(0.05, box.cells());
  ASSERT_TRUE(world.run_until(ExplorationPhase::kFinished, 400));
  EXPECT_EQ(world.map.doors[0].kind, DoorKind::kBlocked);
  EXPECT_TRUE(world.said("trying again what could not be reached, 1 unresolved door"));
  EXPECT_TRUE(world.said(", 1 door blocked"));
}

/// Somebody walks to and fro across the line x = `x_m`, 0.8 m a second, 6 s each way.
void show_walker(MachineWorld& world, double x_m) {
  const double phase_s = std::fmod(world.now_s, 12.0);
  const double y_m = -0.4 + 0.8 * (phase_s < 6.0 ? phase_s : 12.0 - phase_s);
  world.points.points.clear();
  for (double side_m = -0.2; side_m <= 0.2; side_m += 0.005) {
    const Point2 p = world.pose.inverse() * Point2(x_m - std::sqrt(0.05 - side_m * side_m), y_m + side_m);
    world.points.points.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), 0.6F});
  }
}

TEST(ExplorationDoors, GoesThroughADoorBehindWhichSomebodyPacesWhoseTrailIsInEverySweep) {
  MachineWorld world;
  world.grid.apply(0.05, SyntheticRoom().solid(4.35, 0.0, 4.5, 4.0, 0.0, 0.5).cells());
  for (int i = 0; i < 8000 && world.machine.state().phase != ExplorationPhase::kEntering; ++i) {
    show_walker(world, 4.6);
    world.tick();
  }
  EXPECT_EQ(world.machine.state().phase, ExplorationPhase::kEntering);
  EXPECT_EQ(world.map.doors[0].kind, DoorKind::kUnresolved);
}

TEST(ExplorationDoors, ComesBackToADoorThatWasBarredWhenNoOtherIsLeft) {
  MachineWorld world;
  world.grid.apply(0.05, SyntheticRoom().solid(4.3, 1.0, 4.7, 3.0, 0.0, 0.5).cells());
  for (int i = 0; i < 8000 && !world.said("trying again"); ++i) world.tick();
  ASSERT_TRUE(world.said("trying again"));
  EXPECT_EQ(world.map.doors[0].kind, DoorKind::kUnresolved);
  const double yaw_rad = world.pose.yaw_rad;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kScanning, 60));
  EXPECT_NEAR(std::abs(wrap_to_pi(world.pose.yaw_rad - yaw_rad)), kPi, 0.1) << "it looks behind itself first";
  world.grid.apply(0.05, SyntheticRoom().free(4.3, 1.0, 4.7, 3.0, 0.0, 0.5).cells());
  EXPECT_TRUE(world.run_until(ExplorationPhase::kEntering, 200));
}

TEST(ExplorationDoors, LooksForAWayToADoorWhereTheFloorBetweenHasNotBeenSeen) {
  MachineWorld world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kFixing, 200));
  world.grid.apply(0.05, SyntheticRoom().unexplored(1.8, 0, 3.9, 4).cells());
  ASSERT_TRUE(world.run_until(ExplorationPhase::kLooking, 20));
  ASSERT_TRUE(world.run_until(ExplorationPhase::kScanning, 60));
  EXPECT_TRUE(world.said("no way to it has been seen yet"));
  EXPECT_FALSE(world.said("there is no way to it"));
  EXPECT_LT(std::abs(world.pose.yaw_rad), 0.5 * kPi) << "it looks at what it does not know";
  world.grid.apply(0.05, SyntheticRoom().free(1.8, 0, 3.9, 4, 0.0).cells());
  EXPECT_TRUE(world.run_until(ExplorationPhase::kEntering, 100));
}

TEST(ExplorationDoors, LooksBehindItselfWhereTheWayToADoorIsBarred) {
  MachineWorld world;
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
  EXPECT_FALSE(world.said("no other door is left")) << "it does so before it gives the door up";
}

TEST(ExplorationDoors, GivesWayToWhoeverBarsTheWayToADoor) {
  MachineWorld world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kApproaching, 200));
  // People side by side, who wait for the robot to go.
  const double row_x_m = world.pose.x_m + 0.4;
  const auto tick = [&] {
    world.points.points.clear();
    for (int i = 0; i <= 40; ++i) {
      const Point2 p = world.pose.inverse() * Point2(row_x_m, 0.1 * i);
      world.points.points.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), 0.6F});
    }
    world.tick();
  };
  for (int i = 0; i < 1000 && !world.said("the way to it is barred"); ++i) tick();
  ASSERT_TRUE(world.said("the way to it is barred"));
  const double barred_x_m = world.pose.x_m;
  for (int i = 0; i < 1000 && world.motor.phase != SweepPhase::kSweeping; ++i) tick();
  EXPECT_LT(world.pose.x_m, barred_x_m - 0.4);
}

TEST(ExplorationDoors, WaitsForWhoeverStandsInTheOnlyWayAndGoesOn) {
  MachineWorld world;
  world.pose = {0.8, 2.0, 0.0};
  ASSERT_TRUE(world.run_until(ExplorationPhase::kFixing, 200));
  world.pose = {0.8, 2.0, 0.0};
  world.grid.apply(
      0.05, SyntheticRoom().solid(2.0, 0, 2.2, 1.6, 0.0, 0.5).solid(2.0, 2.4, 2.2, 4.0, 0.0, 0.5).cells());
  int stood = 0;
  for (int i = 0; i < 2000 && world.pose.x_m < 2.5 && !world.said("barred"); ++i) {
    world.points.points.clear();
    for (int k = 0; stood < 80 && k <= 16; ++k) {  // 4 s
      const Point2 p = world.pose.inverse() * Point2(2.1, 1.6 + 0.05 * k);
      world.points.points.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), 0.6F});
    }
    const Pose2 before = world.pose;
    world.tick();
    if (world.pose == before && world.pose.x_m > 1.5) ++stood;
  }
  EXPECT_GE(stood, 80);
  EXPECT_GE(world.pose.x_m, 2.5);
  EXPECT_FALSE(world.said("the way to it is barred"));
}

TEST(ExplorationDoors, LooksIntoAGapThatIsWiderThanADoorBeforeItFixesTheRoom) {
  MachineWorld world;
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

TEST(ExplorationDoors, LooksFromInFrontIntoAGapThatMayBeADoorBeforeItFixesTheRoom) {
  MachineWorld world;
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

TEST(ExplorationDoors, SomeoneInTheDoorSendsItBackAndTheDoorIsBlocked) {
  MachineWorld world;
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
