// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/sweeper.hpp"

#include <gtest/gtest.h>

namespace enfilade::explorer {
namespace {

struct Scene {
  Sweeper sweeper{SweeperConfig{}};
  MotorState motor;
  double now_s = 0.0;

  SweepStatus update(Decision& decision) {
    return sweeper.update({.now_ns = from_seconds(now_s), .motor = &motor}, decision);
  }
};

TEST(Sweeper, AsksForTheSpeedThatGivesTheStep) {
  Scene scene;
  scene.motor.sweep_id = 7;  // of the explorer before a restart
  scene.sweeper.begin(1.0, 0);
  Decision decision;
  EXPECT_EQ(scene.update(decision), SweepStatus::kRunning);
  ASSERT_TRUE(decision.sweep);
  EXPECT_EQ(decision.sweep->sweep_id, 8u);
  EXPECT_NEAR(decision.sweep->speed_rad_s, radians(40.0), 1e-12);
}

TEST(Sweeper, DoesNotSweepWhileTheBaseMoves) {
  Scene scene;
  scene.motor.base_moving = true;
  scene.sweeper.begin(1.0, 0);
  Decision decision;
  scene.update(decision);
  EXPECT_FALSE(decision.sweep);
}

TEST(Sweeper, ParksTheSensorWhenDone) {
  Scene scene;
  scene.sweeper.begin(1.0, 0);
  Decision first, second;
  scene.update(first);
  scene.motor = {.sweep_id = 1, .phase = SweepPhase::kDone, .sweep_end_ns = 42};
  EXPECT_EQ(scene.update(second), SweepStatus::kDone);
  EXPECT_EQ(scene.sweeper.end_ns(), 42);
  ASSERT_TRUE(second.sweep);
  EXPECT_EQ(second.sweep->action, SweepAction::kPark);
  EXPECT_EQ(second.sweep->sweep_id, 2u);
}

TEST(Sweeper, RepeatsACommandThatWasLostAndGivesUpInTheEnd) {
  Scene scene;
  scene.sweeper.begin(1.0, 0);
  int repeated = 0;
  SweepStatus status = SweepStatus::kRunning;
  for (; status == SweepStatus::kRunning && scene.now_s < 200.0; scene.now_s += 0.05) {
    Decision decision;
    status = scene.update(decision);
    repeated += decision.sweep.has_value();
  }
  EXPECT_EQ(status, SweepStatus::kFailed);
  EXPECT_GT(repeated, 20);
  EXPECT_LT(scene.now_s, 60.0);
}

}  // namespace
}  // namespace enfilade::explorer
