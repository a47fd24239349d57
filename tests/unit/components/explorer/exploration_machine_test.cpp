// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/unit/components/explorer/machine_world.hpp"

namespace enfilade::explorer {
namespace {

TEST(ExplorationMachine, FixesTheRoomOnlyAfterAFineSweepThatChangesNothing) {
  MachineWorld world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kVerifying, 60));
  EXPECT_GE(world.sweeps, 2);
  ASSERT_TRUE(world.run_until(ExplorationPhase::kFixing, 60));
  EXPECT_TRUE(world.said("the room is stable"));
  EXPECT_FALSE(world.moved_while_sweeping);
}

TEST(ExplorationMachine, AnUnstableRoomIsFixedInTheEnd) {
  MachineWorld world;
  for (int i = 0; i < 20000 && world.machine.state().phase != ExplorationPhase::kFixing; ++i) {
    world.estimate.rectangle.width_m = 4.0 + 0.2 * (world.sweeps % 2);
    world.tick();
  }
  EXPECT_EQ(world.machine.state().phase, ExplorationPhase::kFixing);
  EXPECT_EQ(world.sweeps, 12);
  EXPECT_TRUE(world.said("not stable"));
}

TEST(ExplorationMachine, StaysInTheRoomThoughALaterModelSwallowsADoorWithALintel) {
  for (const bool has_lintel : {false, true}) {
    MachineWorld world;
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
  MachineWorld world;
  world.estimate.found = false;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kStuck, 200));
  EXPECT_TRUE(world.said("no rectangle fits"));
  world.estimate.found = true;  // and it tries again
  EXPECT_TRUE(world.run_until(ExplorationPhase::kFixing, 200));
}

TEST(ExplorationMachine, ANewGridEpochStartsTheZoneAgain) {
  MachineWorld world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kVerifying, 60));
  world.tag.grid_epoch = 9;
  world.estimate.tag = world.tag;
  world.tick();
  EXPECT_EQ(world.machine.state().sweeps_in_zone, 0u);
  EXPECT_TRUE(world.run_until(ExplorationPhase::kFixing, 100));
}

TEST(ExplorationMachine, RestartedInAKnownRoomItGoesOnWithTheDoors) {
  MachineWorld world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kApproaching, 100));
  const int before = world.sweeps;
  world.machine = ExplorationMachine(MachineConfig{});
  ASSERT_TRUE(world.run_until(ExplorationPhase::kApproaching, 30));
  EXPECT_EQ(world.sweeps, before + 1);
  EXPECT_TRUE(world.run_until(ExplorationPhase::kEntering, 100));
}

TEST(ExplorationMachine, RestartedBeyondADoorItEntersTheZoneThere) {
  MachineWorld world;
  ASSERT_TRUE(world.run_until(ExplorationPhase::kApproaching, 100));
  world.machine = ExplorationMachine(MachineConfig{});
  world.pose = {4.8, 2.0, 0.0};
  ASSERT_TRUE(world.run_until(ExplorationPhase::kEntering, 30));
  world.run_until(ExplorationPhase::kWaiting, 1.0);
  EXPECT_TRUE(world.asked_to_enter);
}

}  // namespace
}  // namespace enfilade::explorer
