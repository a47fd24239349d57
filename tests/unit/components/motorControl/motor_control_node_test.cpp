// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/node/motor_control_node.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/node_harness.hpp"

namespace enfilade::motor_control {
namespace {

/// The node and a simulated robot whose motors do what they are told at once.
struct Robot {
  NodeHarness<MotorControlNode, MotorControlConfig> harness{"motorControl", MotorControlConfig{}};
  std::vector<SimActuation>& actuation = harness.collect(topics::kSimActuation);
  std::vector<MotorState>& states = harness.collect(topics::kMotorState);
  std::vector<JointStates>& joints = harness.collect(topics::kJointStates);
  std::vector<Odometry>& odometry = harness.collect(topics::kOdom);
  std::vector<TransformList>& transforms = harness.collect(topics::kTf);
  SimEncoders encoders;

  Robot() { harness.node(); }

  void run_s(double duration_s) {
    for (const StampNs end_ns = harness.now_ns() + from_seconds(duration_s); harness.now_ns() < end_ns;) {
      harness.advance_s(0.005);
      const SimActuation now = actuation.empty() ? SimActuation{} : actuation.back();
      encoders.left_wheel_rad += now.left_wheel_rad_s * 0.005;
      encoders.right_wheel_rad += now.right_wheel_rad_s * 0.005;
      encoders.roll_rad += now.roll_rad_s * 0.005;
      encoders.roll_rad_s = now.roll_rad_s;
      encoders.stamp_ns = harness.now_ns();
      harness.publish(topics::kSimEncoders, encoders);
    }
  }

  void drive_s(const VelocityCommand& command, double duration_s) {
    for (double t_s = 0.0; t_s < duration_s; t_s += 0.05) {
      harness.publish(topics::kCmdVel, command);
      run_s(0.05);
    }
  }

  bool wheels_stand() const {
    return actuation.back().left_wheel_rad_s == 0.0 && actuation.back().right_wheel_rad_s == 0.0;
  }
};

TEST(MotorControlNode, PublishesJointsAtEveryReadingAndOdometryAtFiftyHertz) {
  Robot robot;
  robot.run_s(2.0);
  EXPECT_GE(robot.joints.size(), 399u);
  EXPECT_NEAR(static_cast<double>(robot.odometry.size()), 100.0, 2.0);
  EXPECT_EQ(robot.odometry.size(), robot.transforms.size());
  EXPECT_EQ(robot.joints.back().names.front(), kRollJoint);
  EXPECT_EQ(robot.transforms.back().transforms.front().frame_id, "odom");
  EXPECT_EQ(robot.transforms.back().transforms.front().child_frame_id, "base_link");
}

TEST(MotorControlNode, DrivesAsCommandedAndKnowsWhereItIs) {
  Robot robot;
  robot.drive_s({.linear_m_s = 0.5}, 4.0);
  EXPECT_NEAR(robot.odometry.back().linear_m_s, 0.5, 1e-9);
  EXPECT_TRUE(robot.states.back().base_moving);
  const double travelled_m = 0.5 * 0.08 * (robot.encoders.left_wheel_rad + robot.encoders.right_wheel_rad);
  EXPECT_NEAR(robot.odometry.back().T_odom_base.x_m, travelled_m, 0.02);
}

TEST(MotorControlNode, TheBaseStandsWithinThreeTenthsOfASecondOfTheLastCommand) {
  for (int phase = 0; phase < 10; ++phase) {
    Robot robot;
    robot.run_s(0.005 * phase);
    robot.drive_s({.linear_m_s = 0.5, .angular_rad_s = 1.2}, 3.0);
    ASSERT_FALSE(robot.wheels_stand());
    // The last command came at the start of the 50 ms that have just gone by.
    robot.run_s(0.25 - 0.005);
    EXPECT_TRUE(robot.wheels_stand()) << phase;
  }
}

TEST(MotorControlNode, ReportsASweepWithTheStampsOfItsStroke) {
  Robot robot;
  robot.run_s(0.1);
  robot.harness.publish(
      topics::kSweepCommand,
      {.sweep_id = 5, .action = SweepAction::kSweep, .from_rad = -1.0, .to_rad = 1.0, .speed_rad_s = 0.8});
  robot.run_s(6.0);
  std::vector<SweepPhase> phases;
  for (const MotorState& state : robot.states)
    if (phases.empty() || phases.back() != state.phase) phases.push_back(state.phase);
  EXPECT_EQ(phases, (std::vector{SweepPhase::kParked, SweepPhase::kApproaching, SweepPhase::kSweeping,
                                 SweepPhase::kDone}));
  const MotorState& last = robot.states.back();
  EXPECT_EQ(last.sweep_id, 5u);
  EXPECT_NEAR(seconds(last.sweep_end_ns - last.sweep_start_ns), 2.0 / 0.8, 1e-6);
  EXPECT_FALSE(last.base_moving);
  EXPECT_NE(last.odom_boot, 0u);
}

TEST(MotorControlNode, SilentEncodersStopTheMotorsUntilTheySpeakAgain) {
  Robot robot;
  robot.drive_s({.linear_m_s = 0.3}, 1.0);
  for (int i = 0; i < 20; ++i) {  // commands go on, encoders do not
    robot.harness.publish(topics::kCmdVel, {.linear_m_s = 0.3});
    robot.harness.advance_s(0.05);
  }
  EXPECT_EQ(robot.harness.component().state(), LifecycleState::kEmergency);
  EXPECT_TRUE(robot.wheels_stand());
  robot.drive_s({.linear_m_s = 0.3}, 1.0);
  EXPECT_EQ(robot.harness.component().state(), LifecycleState::kComputing);
  EXPECT_FALSE(robot.wheels_stand());
}

TEST(MotorControlNode, StopsTheMotorsWhenItIsShutDown) {
  Robot robot;
  robot.drive_s({.linear_m_s = 0.3}, 1.0);
  ASSERT_FALSE(robot.wheels_stand());
  robot.harness.node().shutdown();
  robot.harness.advance_s(0.001);
  EXPECT_TRUE(robot.wheels_stand());
}

TEST(MotorControlNode, DefaultsStopTheBaseInTime) { EXPECT_LE(worst_stop_s(MotorControlConfig{}), 0.28); }

}  // namespace
}  // namespace enfilade::motor_control
