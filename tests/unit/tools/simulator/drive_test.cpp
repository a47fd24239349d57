// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/drive.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/tools/simulator/test_worlds.hpp"

namespace enfilade::simulator {
namespace {

constexpr double kStep_s = 0.005;

Pose2 drive_for(Drive& drive, double left_rad_s, double right_rad_s, double duration_s, Random& random,
                Pose2 pose = {}) {
  drive.command(left_rad_s, right_rad_s);
  for (double t = 0; t < duration_s - 1e-9; t += kStep_s) pose = drive.step(kStep_s, random).from(pose);
  return pose;
}

/// What odometry with the nominal figures makes of the encoders.
struct Believed {
  double way_m, turn_rad;
};
Believed believed(const Drive& drive, const DriveConfig& config) {
  const double left_m = drive.left_rad() * config.wheel_radius_m,
               right_m = drive.right_rad() * config.wheel_radius_m;
  return {0.5 * (left_m + right_m), (right_m - left_m) / config.track_m};
}

TEST(Drive, IntegratesAnArcExactlyWhateverTheStep) {
  const DriveStep quarter{.forward_m = kPi / 2, .turn_rad = kPi / 2};  // radius 1
  const Pose2 end = quarter.from({});
  EXPECT_NEAR(end.x_m, 1.0, 1e-12);
  EXPECT_NEAR(end.y_m, 1.0, 1e-12);
  EXPECT_NEAR(end.yaw_rad, kPi / 2, 1e-12);
  Pose2 pieces;
  for (int i = 0; i < 100; ++i) pieces = DriveStep{kPi / 200, kPi / 200}.from(pieces);
  EXPECT_NEAR(pieces.x_m, 1.0, 1e-9);
  EXPECT_NEAR(pieces.y_m, 1.0, 1e-9);
}

TEST(Drive, WheelsSpeedUpNoFasterThanTheirMotorsCan) {
  const DriveConfig config = test::without_noise().drive;
  Drive drive(config);
  Random random(1);
  drive.command(5.0, 5.0);
  double before_m = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double forward_m = drive.step(kStep_s, random).forward_m;
    EXPECT_LE((forward_m - before_m) / kStep_s,
              config.max_wheel_rad_s2 * kStep_s * config.wheel_radius_m + 1e-9);
    before_m = forward_m;
  }
  EXPECT_NEAR(before_m / kStep_s, 0.4, 1e-9);
}

TEST(Drive, OdometryIsExactWithoutErrors) {
  const DriveConfig config = test::without_noise().drive;
  Drive drive(config);
  Random random(1);
  const Pose2 end = drive_for(drive, 2.0, 3.0, 4.0, random);
  const Believed odometry = believed(drive, config);
  EXPECT_NEAR(wrap_to_pi(odometry.turn_rad - end.yaw_rad), 0.0, 1e-9);
}

TEST(Drive, ShippedErrorsAreAsTheReadmeStates) {
  const DriveConfig config;
  double way_error = 0, straight_yaw = 0, turn_error = 0;
  const int runs = 400;
  for (int run = 0; run < runs; ++run) {
    Random random(run + 1);
    Drive straight(config), turning(config);
    const Pose2 end = drive_for(straight, 4.0, 4.0, 12.5, random);
    const Believed straight_odometry = believed(straight, config);
    way_error += std::pow(end.translation().norm() / straight_odometry.way_m - 1.0, 2);
    straight_yaw += std::pow(end.yaw_rad / straight_odometry.way_m, 2);
    const Pose2 turned = drive_for(turning, -2.0, 2.0, 1.66, random);
    const Believed turn_odometry = believed(turning, config);
    turn_error += std::pow((turned.yaw_rad - turn_odometry.turn_rad) / turn_odometry.turn_rad * 90.0, 2);
  }
  EXPECT_NEAR(std::sqrt(way_error / runs), 0.003, 0.0005);           // of the distance
  EXPECT_NEAR(degrees(std::sqrt(straight_yaw / runs)), 0.12, 0.03);  // degrees a metre, over 4 m
  EXPECT_NEAR(std::sqrt(turn_error / runs), 0.4, 0.05);              // degrees in a turn of 90°
}

TEST(Drive, StandsStillWithoutNoise) {
  Drive drive(DriveConfig{});
  Random random(1);
  const Pose2 end = drive_for(drive, 0.0, 0.0, 10.0, random);
  EXPECT_EQ(end, Pose2{});
}

TEST(Drive, EncodersReadWholeTicks) {
  DriveConfig config;
  config.encoder_ticks_per_turn = 100;
  Drive drive(config);
  Random random(1);
  drive_for(drive, 1.0, 1.37, 1.0, random);
  const double ticks = drive.right_rad() / (2 * kPi / 100);
  EXPECT_NEAR(ticks, std::round(ticks), 1e-9);
  EXPECT_GT(ticks, 10);
}

}  // namespace
}  // namespace enfilade::simulator
