// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/rectangle_fit.hpp"

#include <random>

#include <gtest/gtest.h>

namespace enfilade::room_detector {
namespace {

const Rectangle kRoom{0.3, 1.2, -0.7, 4.2, 3.1};

/// Points on the walls with normal noise; a share of each wall is left out, as a door leaves it out.
std::vector<WallPoint> points_on(const Rectangle& room, double sigma_m) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, sigma_m);
  std::vector<WallPoint> points;
  for (int wall = 0; wall < 4; ++wall) {
    for (double s = 0.0; s < room.wall_length_m(wall); s += 0.01) {
      if (s > 0.8 && s < 1.7 && wall == 1) continue;
      points.push_back(
          {room.corner(wall) + s * room.wall(wall).direction() + noise(random) * room.normal(wall), 1.0});
    }
  }
  return points;
}

TEST(RectangleFitter, RecoversARoomFromNoisyReturns) {
  const auto points = points_on(kRoom, 0.01);
  Rectangle start = kRoom;
  start.yaw_rad += radians(0.5);
  start.width_m += 0.04;
  start.y_m += 0.03;
  const auto fit = RectangleFitter({}).fit(points, start, 0.075);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->rectangle.width_m, kRoom.width_m, 0.003);
  EXPECT_NEAR(fit->rectangle.height_m, kRoom.height_m, 0.003);
  EXPECT_NEAR(fit->rectangle.x_m, kRoom.x_m, 0.003);
  EXPECT_NEAR(fit->rectangle.y_m, kRoom.y_m, 0.003);
  EXPECT_NEAR(fit->rectangle.yaw_rad, kRoom.yaw_rad, 0.001);
  EXPECT_NEAR(std::sqrt(fit->covariance(3, 3)), 0.01 * std::sqrt(2.0 / 280), 5e-4);
}

TEST(RectangleFitter, ReachesWallsAQuarterMetreOff) {
  Rectangle start = kRoom;
  start.width_m += 0.2;
  start.x_m -= 0.1;
  start.height_m -= 0.2;
  const auto fit = RectangleFitter({}).fit(points_on(kRoom, 0.01), start, 0.4);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->rectangle.width_m, kRoom.width_m, 0.003);
  EXPECT_NEAR(fit->rectangle.height_m, kRoom.height_m, 0.003);
}

TEST(RectangleFitter, StaysOnTheWallBesideACupboard) {
  auto points = points_on(kRoom, 0.01);
  for (double s = 1.0; s < 2.0; s += 0.01) {  // a front 0.08 m before a third of wall 0
    points.push_back({kRoom.corner(0) + s * kRoom.wall(0).direction() - 0.08 * kRoom.normal(0), 1.0});
  }
  const auto fit = RectangleFitter({}).fit(points, kRoom, 0.075);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->rectangle.width_m, kRoom.width_m, 0.005);
}

TEST(RectangleFitter, LeavesAnUnseenWallWhereItWas) {
  auto points = points_on(kRoom, 0.01);
  std::erase_if(points, [](const WallPoint& p) { return (kRoom.pose().inverse() * p.position).x() < -1.9; });
  const auto fit = RectangleFitter({}).fit(points, kRoom, 0.075);
  ASSERT_TRUE(fit);
  const Rectangle& r = fit->rectangle;
  EXPECT_NEAR(rotate(-r.yaw_rad, r.corner(3) - kRoom.corner(3)).x(), 0.0, 0.005);
}

TEST(RectangleFitter, FindsTheDeviationOfThePose) {
  const Pose2 deviation{0.03, -0.02, radians(0.8)};
  const Rectangle seen = deviation * kRoom;
  const auto fit = RectangleFitter({}).fit_pose(points_on(seen, 0.01), kRoom, 0.12);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->rectangle.x_m, seen.x_m, 0.003);
  EXPECT_NEAR(fit->rectangle.y_m, seen.y_m, 0.003);
  EXPECT_NEAR(fit->rectangle.yaw_rad, seen.yaw_rad, 0.001);
  EXPECT_EQ(fit->rectangle.width_m, kRoom.width_m);
}

TEST(RectangleFitter, GivesNoPoseFromOneWall) {
  auto points = points_on(kRoom, 0.01);
  std::erase_if(points, [](const WallPoint& p) { return (kRoom.pose().inverse() * p.position).x() < 2.0; });
  EXPECT_FALSE(RectangleFitter({}).fit_pose(points, kRoom, 0.12));
}

}  // namespace
}  // namespace enfilade::room_detector
