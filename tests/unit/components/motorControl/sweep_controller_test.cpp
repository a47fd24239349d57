// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/core/sweep_controller.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "interfaces/geometry/angles.hpp"

namespace enfilade::motor_control {
namespace {

constexpr double kReading_s = 0.005;
constexpr int kReadingsPerControl = 4;

/// A motor that turns at the rate it is told, read at 200 Hz and controlled at 50 Hz, as the node does.
struct Motor {
  SweepController controller{SweepControllerConfig{}};
  double angle_rad = 0.0;
  double rate_rad_s = 0.0;
  int tick = 0;
  double lowest_rad = 0.0, highest_rad = 0.0;

  StampNs now_ns() const { return from_seconds(tick * kReading_s); }

  void step() {
    controller.observe(now_ns(), angle_rad);
    if (tick % kReadingsPerControl == 0) rate_rad_s = controller.speed(kReading_s * kReadingsPerControl);
    angle_rad += rate_rad_s * kReading_s;
    lowest_rad = std::min(lowest_rad, angle_rad);
    highest_rad = std::max(highest_rad, angle_rad);
    ++tick;
  }

  bool run_until(SweepPhase phase, double timeout_s = 30.0) {
    for (const StampNs end_ns = now_ns() + from_seconds(timeout_s); now_ns() < end_ns;) {
      if (controller.phase() == phase) return true;
      step();
    }
    return false;
  }
};

SweepCommand sweep(std::uint32_t id, double from_rad, double to_rad, double speed_rad_s) {
  return {.sweep_id = id,
          .action = SweepAction::kSweep,
          .from_rad = from_rad,
          .to_rad = to_rad,
          .speed_rad_s = speed_rad_s};
}

TEST(SweepController, StrokeCoversTheRangeAtConstantSpeed) {
  for (const double speed : {0.1, 0.35, 0.7, 1.0}) {
    Motor motor;
    ASSERT_EQ(motor.controller.command(sweep(1, -kPi / 2, kPi / 2, speed)), SweepVerdict::kAccepted);
    ASSERT_TRUE(motor.run_until(SweepPhase::kSweeping));
    const double from_rad = motor.angle_rad;
    EXPECT_NEAR(motor.rate_rad_s, speed, 1e-12);
    while (motor.controller.phase() == SweepPhase::kSweeping) {
      ASSERT_NEAR(motor.rate_rad_s, speed, 1e-12) << motor.angle_rad;
      motor.step();
    }
    EXPECT_NEAR(std::abs(motor.angle_rad - from_rad), kPi, 0.06);
    const double took_s = seconds(motor.controller.sweep_end_ns() - motor.controller.sweep_start_ns());
    EXPECT_NEAR(took_s, kPi / speed, 1e-6) << "stamps are found between readings";
  }
}

TEST(SweepController, StaysWithinTheOverrunAndEndsAtRest) {
  Motor motor;
  const SweepControllerConfig config;
  motor.controller.command(sweep(1, -kPi, kPi, 99.0));
  ASSERT_TRUE(motor.run_until(SweepPhase::kDone));
  for (int i = 0; i < 200; ++i) motor.step();
  EXPECT_EQ(motor.rate_rad_s, 0.0);
  EXPECT_GT(motor.lowest_rad, config.lowest_rad - config.overrun_rad);
  EXPECT_LT(motor.highest_rad, config.highest_rad + config.overrun_rad);
  const double took_s = seconds(motor.controller.sweep_end_ns() - motor.controller.sweep_start_ns());
  EXPECT_NEAR(took_s, kPi / motor.controller.max_stroke_speed_rad_s(), 1e-6);
}

TEST(SweepController, BeginsAtTheNearerEnd) {
  for (const double at_rad : {-1.0, 1.0}) {
    Motor motor;
    motor.angle_rad = at_rad;
    motor.controller.command(sweep(1, 1.2, -1.2, 0.5));
    ASSERT_TRUE(motor.run_until(SweepPhase::kSweeping));
    EXPECT_NEAR(motor.angle_rad, at_rad > 0 ? 1.2 : -1.2, 0.02);
    ASSERT_TRUE(motor.run_until(SweepPhase::kDone));
    EXPECT_NEAR(motor.angle_rad, at_rad > 0 ? -1.2 : 1.2, 0.02);
  }
}

TEST(SweepController, StampsAreOfThePassagesOfTheEnds) {
  Motor motor;
  motor.angle_rad = -2.0;
  motor.controller.command(sweep(1, -1.0, 1.0, 0.5));
  double before_rad = motor.angle_rad, crossed_s = 0.0;
  while (motor.controller.phase() != SweepPhase::kDone) {
    before_rad = motor.angle_rad;
    motor.step();
    if (before_rad < -1.0 && motor.angle_rad >= -1.0)
      crossed_s = (motor.tick - 1 + (-1.0 - before_rad) / (motor.angle_rad - before_rad)) * kReading_s;
  }
  EXPECT_NEAR(seconds(motor.controller.sweep_start_ns()), crossed_s, 1e-6);
}

TEST(SweepController, RepeatedAndOldCommandsAreIgnored) {
  Motor motor;
  EXPECT_EQ(motor.controller.command(sweep(7, -0.5, 0.5, 1.0)), SweepVerdict::kAccepted);
  ASSERT_TRUE(motor.run_until(SweepPhase::kDone));
  EXPECT_EQ(motor.controller.command(sweep(7, -0.5, 0.5, 1.0)), SweepVerdict::kKnown);
  EXPECT_EQ(motor.controller.command(sweep(3, -0.5, 0.5, 1.0)), SweepVerdict::kKnown);
  EXPECT_EQ(motor.controller.phase(), SweepPhase::kDone);
  EXPECT_EQ(motor.controller.command(sweep(8, -0.5, 0.5, 1.0)), SweepVerdict::kAccepted);
  EXPECT_EQ(motor.controller.sweep_start_ns(), 0);
  EXPECT_TRUE(motor.run_until(SweepPhase::kDone));
}

TEST(SweepController, ParksWhereItIsToldAndClampsToTheRange) {
  Motor motor;
  motor.controller.command({.sweep_id = 1, .action = SweepAction::kPark, .from_rad = 0.8});
  ASSERT_TRUE(motor.run_until(SweepPhase::kParked));
  for (int i = 0; i < 400; ++i) motor.step();
  EXPECT_NEAR(motor.angle_rad, 0.8, 1e-3);
  motor.controller.command({.sweep_id = 2, .action = SweepAction::kPark, .from_rad = -9.0});
  EXPECT_EQ(motor.controller.phase(), SweepPhase::kApproaching);
  ASSERT_TRUE(motor.run_until(SweepPhase::kParked));
  for (int i = 0; i < 400; ++i) motor.step();
  EXPECT_NEAR(motor.angle_rad, SweepControllerConfig{}.lowest_rad, 1e-3);
}

TEST(SweepController, RefusesWhatIsNoNumberOrNoRange) {
  SweepController controller{SweepControllerConfig{}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(controller.command(sweep(1, nan, 1.0, 1.0)), SweepVerdict::kInvalid);
  EXPECT_EQ(controller.command(sweep(1, -1.0, 1.0, 0.0)), SweepVerdict::kInvalid);
  EXPECT_EQ(controller.command(sweep(1, 0.3, 0.3, 1.0)), SweepVerdict::kInvalid);
  EXPECT_EQ(controller.command(sweep(1, 5.0, 6.0, 1.0)), SweepVerdict::kInvalid);
  EXPECT_EQ(controller.sweep_id(), 0u);
}

TEST(SweepController, AnInterruptedStrokeIsDoneAnewAfterARestart) {
  Motor motor;
  motor.controller.command(sweep(1, -1.0, 1.0, 0.5));
  ASSERT_TRUE(motor.run_until(SweepPhase::kSweeping));
  for (int i = 0; i < 100; ++i) motor.step();
  motor.controller.restart();
  EXPECT_EQ(motor.controller.phase(), SweepPhase::kApproaching);
  EXPECT_EQ(motor.controller.sweep_start_ns(), 0);
  ASSERT_TRUE(motor.run_until(SweepPhase::kDone));
  EXPECT_NEAR(seconds(motor.controller.sweep_end_ns() - motor.controller.sweep_start_ns()), 4.0, 1e-6);
}

}  // namespace
}  // namespace enfilade::motor_control
