// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/odometry_drift.hpp"

#include <gtest/gtest.h>

namespace enfilade::grid_builder {
namespace {

const Eigen::Matrix3d kSure = 1e-6 * Eigen::Matrix3d::Identity();

/// A robot whose wheels are larger than odometry takes them to be, the left one a little less so.
struct Robot {
  double distance = 1.03, turn = 0.98, curve_rad_m = radians(0.3);
  Pose2 T_zone_base, T_odom_base;

  void drive(double told_m, double told_rad, OdometryDrift& drift) {
    constexpr int kSteps = 200;
    const double way_m = told_m / kSteps, turned_rad = told_rad / kSteps;
    for (int i = 0; i < kSteps; ++i) {
      T_zone_base = T_zone_base * Pose2{way_m * distance, 0.0, turned_rad * turn + way_m * curve_rad_m};
      T_odom_base = T_odom_base * Pose2{way_m, 0.0, turned_rad};
      drift.move(T_odom_base);
    }
  }
  Pose2 correction(const OdometryDrift& drift) const { return T_zone_base * drift.T_zone_base().inverse(); }
  double miss_m(const OdometryDrift& drift) const {
    return (drift.T_zone_base().translation() - T_zone_base.translation()).norm();
  }
};

/// Drives about and is told its place after each way.
void learn(Robot& robot, OdometryDrift& drift) {
  drift.move(robot.T_odom_base);
  for (const auto& [way_m, turn_rad] :
       {std::pair{0.0, 3.0}, {1.2, 0.3}, {0.8, -2.0}, {1.0, 1.5}, {1.5, 0.0}}) {
    robot.drive(way_m, turn_rad, drift);
    ASSERT_TRUE(drift.settle(robot.correction(drift), kSure));
  }
}

TEST(OdometryDrift, IsWhereOdometryIsBeforeAnythingWasMeasured) {
  OdometryDrift drift({});
  Robot robot;
  drift.move(robot.T_odom_base);
  robot.drive(1.5, 1.0, drift);
  EXPECT_NEAR((drift.T_zone_base().translation() - robot.T_odom_base.translation()).norm(), 0.0, 1e-9);
}

TEST(OdometryDrift, LearnsFromKnownPlacesHowFarTheRobotGoesWhereThereAreNone) {
  OdometryDrift drift({});
  Robot robot;
  learn(robot, drift);
  EXPECT_NEAR(drift.distance_scale(), robot.distance, 0.004);
  EXPECT_NEAR(drift.turn_scale(), robot.turn, 0.004);
  robot.drive(1.6, 0.0, drift);  // through a door
  EXPECT_LT(robot.miss_m(drift), 0.010) << "odometry alone misses by 48 mm";
}

TEST(OdometryDrift, RefusesAPlaceThatOdometryCannotHaveMissed) {
  OdometryDrift drift({});
  Robot robot;
  learn(robot, drift);
  robot.drive(1.0, 0.0, drift);
  const Pose2 before = drift.T_zone_odom();
  EXPECT_FALSE(drift.settle({0.3, 0.0, 0.0}, kSure));
  EXPECT_EQ(drift.T_zone_odom(), before);
}

TEST(OdometryDrift, LeavesToOdometryWhatTheWallsDoNotTell) {
  OdometryDrift drift({});
  Robot robot;
  drift.move(robot.T_odom_base);
  robot.drive(2.0, 0.0, drift);
  const Pose2 before = drift.T_zone_base();
  Eigen::Matrix3d by_one_wall = kSure;
  by_one_wall(1, 1) = 1.0;
  ASSERT_TRUE(drift.settle({0.06, 0.0, 0.0}, by_one_wall));
  EXPECT_NEAR(drift.T_zone_base().x_m, before.x_m + 0.06, 0.003);
  EXPECT_NEAR(drift.T_zone_base().y_m, before.y_m, 0.003);
  EXPECT_GT(drift.distance_scale(), 1.02);
}

TEST(OdometryDrift, AllowsForMoreTheLongerTheWay) {
  OdometryDrift drift({});
  Robot robot;
  drift.move(robot.T_odom_base);
  robot.drive(0.0, radians(20.0), drift);
  EXPECT_FALSE(drift.settle(robot.correction(drift) * Pose2{0.0, 0.0, radians(6.0)}, kSure));
  robot.drive(0.0, radians(160.0), drift);
  EXPECT_TRUE(drift.settle(robot.correction(drift) * Pose2{0.0, 0.0, radians(6.0)}, kSure));
}

TEST(OdometryDrift, DoubtsItselfWhenPlacesAreRefusedAgainAndAgain) {
  OdometryDrift drift({});
  Robot robot;
  learn(robot, drift);
  robot.distance = 0.97;  // something has got between the wheels
  int refused = 0;
  for (; refused < 6; ++refused) {
    robot.drive(1.5, 0.4, drift);
    if (drift.settle(robot.correction(drift), kSure)) break;
  }
  EXPECT_GT(refused, 0);
  EXPECT_LT(refused, 6);
}

TEST(OdometryDrift, KnowsItsWheelsWhenOdometryCountsFromAnotherOrigin) {
  OdometryDrift drift({});
  Robot robot;
  learn(robot, drift);
  const Pose2 stood = drift.T_zone_base();
  drift.forget_odometry();
  EXPECT_EQ(drift.T_zone_odom(), stood) << "where the robot stands is no other place for that";
  robot.T_odom_base = Pose2{};
  robot.T_zone_base = stood;
  drift.move(robot.T_odom_base);
  robot.drive(1.6, 0.0, drift);
  EXPECT_LT(robot.miss_m(drift), 0.010);
}

}  // namespace
}  // namespace enfilade::grid_builder
