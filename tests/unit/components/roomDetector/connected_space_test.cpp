// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/connected_space.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace enfilade::room_detector {
namespace {

using Kind = ConnectedSpace::Kind;

/// Two rooms of 40 × 40 columns side by side; what lies at x = 40 and 41 is told by `between`.
ConnectedSpace two_rooms(const std::function<Kind(int y)>& between) {
  ConnectedSpace space(0.05, Point2::Zero(), 6.0);
  for (int x = 0; x < 82; ++x) {
    for (int y = 0; y < 40; ++y)
      space.change(x, y, Kind::kUnknown, x == 40 || x == 41 ? between(y) : Kind::kOpen);
  }
  space.flood({0.5, 0.5});
  return space;
}

TEST(ConnectedSpace, SpaceBehindAWallIsApart) {
  const auto space = two_rooms([](int) { return Kind::kWall; });
  EXPECT_TRUE(space.is_apart(60, 20));
  EXPECT_FALSE(space.is_apart(20, 35)) << "the robot's own room";
  EXPECT_FALSE(space.is_apart(40, 20)) << "the wall itself";
  EXPECT_FALSE(space.is_apart(20, 60)) << "not known";
}

TEST(ConnectedSpace, SpaceBehindAGapInTheWallIsNot) {
  const auto space = two_rooms([](int y) { return y >= 10 && y < 18 ? Kind::kOpen : Kind::kWall; });
  EXPECT_FALSE(space.is_apart(60, 20));
}

TEST(ConnectedSpace, AGapThatWasNotSeenConnectsNothing) {
  const auto space = two_rooms([](int y) { return y >= 10 && y < 18 ? Kind::kUnknown : Kind::kWall; });
  EXPECT_TRUE(space.is_apart(60, 20));
}

TEST(ConnectedSpace, AWallOneColumnThinIsTightInEveryDirection) {
  for (int deg = 0; deg < 180; ++deg) {
    const Point2 normal = rotate(deg * kPi / 180.0, {1.0, 0.0});
    const double width = std::max(std::abs(normal.x()), std::abs(normal.y()));  // columns meet at corners
    ConnectedSpace space(0.05, Point2::Zero(), 3.0);
    for (int x = -70; x < 70; ++x) {
      for (int y = -70; y < 70; ++y) {
        const double across = normal.dot(Point2(x, y)) - 10.3;
        space.change(x, y, Kind::kUnknown, std::abs(across) <= 0.5 * width ? Kind::kWall : Kind::kOpen);
      }
    }
    space.flood(Point2::Zero());
    const Point2 behind = 40.0 * normal;
    EXPECT_TRUE(space.is_apart(static_cast<int>(behind.x()), static_cast<int>(behind.y()))) << deg << "°";
  }
}

TEST(ConnectedSpace, FollowsWhatChanges) {
  auto space = two_rooms([](int) { return Kind::kWall; });
  const auto set_gap = [&](Kind from, Kind to) {
    for (int y = 10; y < 18; ++y)
      for (const int x : {40, 41}) space.change(x, y, from, to);
    space.flood({0.5, 0.5});
  };
  set_gap(Kind::kWall, Kind::kOpen);
  EXPECT_FALSE(space.is_apart(60, 20));
  set_gap(Kind::kOpen, Kind::kWall);
  EXPECT_TRUE(space.is_apart(60, 20));
  space.flood({3.0, 0.5});  // the robot has gone through
  EXPECT_FALSE(space.is_apart(60, 20));
  EXPECT_TRUE(space.is_apart(20, 20));
}

TEST(ConnectedSpace, NothingIsApartFromARobotWhosePlaceIsNotKnown) {
  ConnectedSpace space(0.05, Point2::Zero(), 6.0);
  for (int x = 0; x < 10; ++x) space.change(x, 0, Kind::kUnknown, Kind::kOpen);
  for (const Point2& robot : {Point2(3.0, 3.0), Point2(-100.0, 1e6)}) {
    space.flood(robot);
    EXPECT_FALSE(space.is_apart(4, 0));
  }
}

TEST(ConnectedSpace, WhatLiesBeyondItsReachDoesNotMatter) {
  ConnectedSpace space(0.05, Point2::Zero(), 2.0);
  for (const int far : {-30'000, -200, 200, 30'000}) {
    space.change(far, far, Kind::kUnknown, Kind::kOpen);
    EXPECT_FALSE(space.is_apart(far, far));
  }
}

}  // namespace
}  // namespace enfilade::room_detector
