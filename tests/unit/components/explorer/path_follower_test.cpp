// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/path_follower.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "interfaces/geometry/segment.hpp"

namespace enfilade::explorer {
namespace {

constexpr double kPeriod_s = 0.05;

/// A base with bounded accelerations and one period of delay.
struct Base {
  Pose2 pose;
  VelocityCommand speed, commanded;

  void step(const VelocityCommand& command) {
    const auto towards = [](double from, double to, double most) {
      return from + std::clamp(to - from, -most, most);
    };
    speed.linear_m_s = towards(speed.linear_m_s, commanded.linear_m_s, 0.6 * kPeriod_s);
    speed.angular_rad_s = towards(speed.angular_rad_s, commanded.angular_rad_s, 2.0 * kPeriod_s);
    commanded = command;
    pose = pose * Pose2{speed.linear_m_s * kPeriod_s, 0.0, speed.angular_rad_s * kPeriod_s};
  }
};

struct Ride {
  Base base;
  bool done = false;
  double farthest_off_m = 0.0;
};

Ride ride(const std::vector<Point2>& points, std::optional<double> yaw, const Pose2& start) {
  PathFollower follower({});
  follower.follow(points, yaw);
  Ride ride{.base = {.pose = start}};
  for (int i = 0; i < 4000 && !ride.done; ++i) {
    const auto step = follower.update(ride.base.pose, 1.0);
    ride.done = step.done;
    ride.base.step(step.velocity);
    double off_m = 10.0;
    for (std::size_t k = 1; k < points.size(); ++k) {
      off_m = std::min(off_m, distance(ride.base.pose.translation(), {points[k - 1], points[k]}));
    }
    if (points.size() > 1) ride.farthest_off_m = std::max(ride.farthest_off_m, off_m);
  }
  for (int i = 0; i < 20; ++i) ride.base.step({});
  return ride;
}

TEST(PathFollower, ArrivesWithinThreeCentimetresAndTwoDegrees) {
  for (const double yaw : {0.0, 2.0, -3.0}) {
    const Ride r = ride({{0, 0}, {2, 0}, {2, 1.5}, {0.5, 1.0}}, yaw, {0, 0, 1.0});
    ASSERT_TRUE(r.done);
    EXPECT_LT((r.base.pose.translation() - Point2(0.5, 1.0)).norm(), 0.03);
    EXPECT_LT(std::abs(wrap_to_pi(r.base.pose.yaw_rad - yaw)), radians(2.5));
  }
}

TEST(PathFollower, KeepsToTheLine) {
  const Ride r = ride({{0, 0}, {2, 0}, {2, 2}, {0, 0.5}}, std::nullopt, {0, 0, 0});
  ASSERT_TRUE(r.done);
  EXPECT_LT(r.farthest_off_m, 0.04);
}

TEST(PathFollower, WithoutAPathItOnlyTurns) {
  const Ride r = ride({}, kPi, {1, 2, 0.1});
  ASSERT_TRUE(r.done);
  EXPECT_LT((r.base.pose.translation() - Point2(1, 2)).norm(), 1e-9);
  EXPECT_LT(std::abs(wrap_to_pi(r.base.pose.yaw_rad - kPi)), radians(2.5));
}

TEST(PathFollower, NeverGoesFasterThanTheSurroundingsAllow) {
  const PathFollowerConfig config;
  PathFollower follower(config);
  follower.follow({{0, 0}, {3, 0}}, std::nullopt);
  EXPECT_DOUBLE_EQ(follower.update({0.5, 0, 0}, 0.1).velocity.linear_m_s, 0.1);
  EXPECT_DOUBLE_EQ(follower.update({0.5, 0, 0}, 9.9).velocity.linear_m_s, config.linear_m_s);
}

}  // namespace
}  // namespace enfilade::explorer
