// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/door_crossing.hpp"

#include <gtest/gtest.h>

namespace enfilade::explorer {
namespace {

const DoorCorridor kCorridor{.from = {1, 1, 0.5 * kPi}, .to = {1, 2.5, 0.5 * kPi}, .clearance_m = 0.4};

struct Drive1 {
  CrossingStatus status = CrossingStatus::kUnderWay;
  Pose2 pose;
  double off_in_the_wall_m = 0.0;
};

Drive1 drive(Pose2 pose, bool backwards, const PointCloud* points = nullptr) {
  DoorCrossing crossing({}, {});
  crossing.begin(kCorridor, backwards, 0);
  const MotorState motor;
  Drive1 result{.pose = pose};
  for (int i = 0; i < 2000 && result.status == CrossingStatus::kUnderWay; ++i) {
    Observation seen{
        .now_ns = from_seconds(0.05 * i), .T_zone_base = result.pose, .motor = &motor, .points = points};
    Decision decision;
    result.status = crossing.update(seen, decision);
    result.pose =
        result.pose * Pose2{0.05 * decision.velocity.linear_m_s, 0.0, 0.05 * decision.velocity.angular_rad_s};
    const bool in_wall = result.pose.y_m > 1.7 && result.pose.y_m < 1.9;
    if (in_wall)
      result.off_in_the_wall_m = std::max(result.off_in_the_wall_m, std::abs(result.pose.x_m - 1.0));
  }
  return result;
}

TEST(DoorCrossing, GoesThroughCentredAndSquareFromABadStart) {
  const auto result = drive({1.06, 1.0, radians(80.0)}, false);
  EXPECT_EQ(result.status, CrossingStatus::kDone);
  EXPECT_LT(result.off_in_the_wall_m, 0.03);
  EXPECT_NEAR(result.pose.y_m, 2.5, 0.03);
  EXPECT_NEAR(result.pose.yaw_rad, 0.5 * kPi, radians(3.0));
}

TEST(DoorCrossing, GoesBackTheWayItCame) {
  const auto result = drive({1.03, 2.0, radians(95.0)}, true);
  EXPECT_EQ(result.status, CrossingStatus::kDone);
  EXPECT_NEAR(result.pose.y_m, 1.0, 0.03);
  EXPECT_NEAR(result.pose.x_m, 1.0, 0.03);
}

TEST(DoorCrossing, StandsBeforeSomeoneInTheDoorAndGivesUp) {
  const PointCloud person{.points = {{0.3F, 0.0F, 0.6F}}};
  const auto result = drive({1, 1.2, 0.5 * kPi}, false, &person);
  EXPECT_EQ(result.status, CrossingStatus::kBlocked);
  EXPECT_NEAR(result.pose.y_m, 1.2, 1e-9);
}

}  // namespace
}  // namespace enfilade::explorer
