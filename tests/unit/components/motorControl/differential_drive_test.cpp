// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/core/differential_drive.hpp"

#include <gtest/gtest.h>

namespace enfilade::motor_control {
namespace {

const DifferentialDriveConfig kConfig{.wheel_radius_m = 0.08, .track_m = 0.34};

TEST(DifferentialDrive, WheelRatesAndBaseSpeedUndoEachOther) {
  const DifferentialDrive drive(kConfig);
  for (const VelocityCommand speed : {VelocityCommand{0.5, 0.0}, {0.0, 1.2}, {-0.2, 0.7}, {0.3, -1.1}}) {
    const VelocityCommand again = drive.base_speed(drive.wheel_rates(speed));
    EXPECT_NEAR(again.linear_m_s, speed.linear_m_s, 1e-12);
    EXPECT_NEAR(again.angular_rad_s, speed.angular_rad_s, 1e-12);
  }
}

TEST(DifferentialDrive, EqualWheelsGoStraightByTheirCircumference) {
  const Pose2 way = DifferentialDrive(kConfig).arc({2.0 * kPi, 2.0 * kPi});
  EXPECT_NEAR(way.x_m, 2.0 * kPi * kConfig.wheel_radius_m, 1e-12);
  EXPECT_EQ(way.y_m, 0.0);
  EXPECT_EQ(way.yaw_rad, 0.0);
}

TEST(DifferentialDrive, ArcEndsWhereTheCircleSays) {
  const DifferentialDrive drive(kConfig);
  const double radius_m = 1.7;
  for (const double turn_rad : {-3.0, -0.4, 1e-7, 1e-3, 0.5, 2.0, 6.0}) {
    const Wheels turned = drive.wheel_rates({.linear_m_s = radius_m * turn_rad, .angular_rad_s = turn_rad});
    const Pose2 way = drive.arc(turned);
    EXPECT_NEAR(way.x_m, radius_m * std::sin(turn_rad), 1e-12) << turn_rad;
    EXPECT_NEAR(way.y_m, radius_m * (1.0 - std::cos(turn_rad)), 1e-12) << turn_rad;
    EXPECT_NEAR(way.yaw_rad, turn_rad, 1e-12);
  }
}

TEST(DifferentialDrive, RefusesABaseWithoutWheels) {
  EXPECT_THROW(DifferentialDrive({.wheel_radius_m = 0.0, .track_m = 0.3}), std::invalid_argument);
  EXPECT_THROW(DifferentialDrive({.wheel_radius_m = 0.1, .track_m = -0.3}), std::invalid_argument);
}

}  // namespace
}  // namespace enfilade::motor_control
