// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/core/wheel_odometry.hpp"

#include <gtest/gtest.h>

namespace enfilade::motor_control {
namespace {

constexpr StampNs kStep_ns = 5'000'000;

struct Driven {
  WheelOdometry odometry{WheelOdometryConfig{}, DifferentialDrive(DifferentialDriveConfig{})};
  DifferentialDrive drive{DifferentialDriveConfig{}};
  StampNs now_ns = 0;
  Wheels angles_rad{12.0, -7.0};  // encoders need not start at 0

  Driven() { odometry.update(now_ns, angles_rad); }

  void go(const VelocityCommand& speed, double duration_s) {
    const Wheels rates = drive.wheel_rates(speed);
    for (const StampNs end_ns = now_ns + from_seconds(duration_s); now_ns < end_ns;) {
      now_ns += kStep_ns;
      angles_rad.left += rates.left * seconds(kStep_ns);
      angles_rad.right += rates.right * seconds(kStep_ns);
      odometry.update(now_ns, angles_rad);
    }
  }
};

TEST(WheelOdometry, StartsAtTheOriginWhateverTheEncodersRead) {
  EXPECT_EQ(Driven().odometry.T_odom_base(), Pose2{});
}

TEST(WheelOdometry, AQuarterOfACircleInManyStepsIsExact) {
  Driven base;
  base.go({.linear_m_s = 0.25 * kPi, .angular_rad_s = 0.25 * kPi}, 2.0);  // radius 1 m
  EXPECT_NEAR(base.odometry.T_odom_base().x_m, 1.0, 1e-9);
  EXPECT_NEAR(base.odometry.T_odom_base().y_m, 1.0, 1e-9);
  EXPECT_NEAR(base.odometry.T_odom_base().yaw_rad, 0.5 * kPi, 1e-9);
}

TEST(WheelOdometry, MeasuresTheSpeedDriven) {
  Driven base;
  base.go({.linear_m_s = 0.3, .angular_rad_s = -0.8}, 0.2);
  EXPECT_NEAR(base.odometry.speed().linear_m_s, 0.3, 1e-9);
  EXPECT_NEAR(base.odometry.speed().angular_rad_s, -0.8, 1e-9);
}

TEST(WheelOdometry, TheBaseCountsAsMovingUntilItHasStoodForTheSettleTime) {
  Driven base;
  EXPECT_FALSE(base.odometry.moving());
  base.go({.linear_m_s = 0.3}, 0.1);
  EXPECT_TRUE(base.odometry.moving());
  base.go({}, 0.09);
  EXPECT_TRUE(base.odometry.moving());
  base.go({}, 0.06);
  EXPECT_FALSE(base.odometry.moving());
}

}  // namespace
}  // namespace enfilade::motor_control
