// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/passing_things.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/explorer/synthetic_room.hpp"

namespace enfilade::explorer {
namespace {

constexpr double kResolutionM = SyntheticRoom::kResolutionM;

/// What a beam every 5 mm shows of a face at `x_m`, in the frame of a robot at (1, 1).
void add_face(double x_m, double y0_m, double y1_m, std::vector<Point3f>& line) {
  for (double y = y0_m; y < y1_m; y += 0.005)
    line.push_back({static_cast<float>(x_m - 1.0), static_cast<float>(y - 1.0), 0.6F});
}

/// A watch of 100 lines, in which a face from y0 to y1 is seen in so many of them.
PassingThings watched(double y0_m, double y1_m, int lines) {
  PassingThings things;
  things.begin_watch();
  for (int i = 0; i < 100; ++i) {
    std::vector<Point3f> line;
    if (i < lines) add_face(2.02, y0_m, y1_m, line);
    things.watch({1.0, 1.0, 0.0}, line, kResolutionM);
  }
  things.end_watch();
  return things;
}

TEST(PassingThings, WhereSomethingIsSeenNowAndThenNothingStands) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).solid(2.0, 1.0, 2.1, 1.5, 0.0, 0.4).grid();
  EXPECT_EQ(watched(1.0, 1.5, 30).trail(grid).size(), 20u);
}

TEST(PassingThings, WhatIsSeenMostOfTheTimeStands) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).solid(2.0, 1.0, 2.1, 1.5, 0.0, 0.4).grid();
  EXPECT_TRUE(watched(1.0, 1.5, 70).trail(grid).empty());
  EXPECT_TRUE(watched(1.0, 1.5, 0).trail(grid).empty());
}

TEST(PassingThings, WhatIsLowAndStandsAtTheWaysideIsNoTrail) {
  const auto box = SyntheticRoom().room(0, 0, 4, 4).solid(2.05, 1.0, 2.5, 1.5, 0.0, 0.3).grid();
  EXPECT_TRUE(watched(0.5, 2.0, 30).trail(box).empty());
}

TEST(PassingThings, ASingleEchoIsNobody) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).solid(2.0, 1.0, 2.1, 1.5, 0.0, 0.4).grid();
  EXPECT_TRUE(watched(1.2, 1.205, 30).trail(grid).empty());
}

TEST(PassingThings, WhatHasComeToStandWhereSomebodyPassedStands) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).solid(2.0, 1.0, 2.1, 1.5, 0.0, 0.4).grid();
  PassingThings things = watched(1.0, 1.5, 30);
  things.begin_watch();
  std::vector<Point3f> line;
  add_face(2.02, 1.0, 1.5, line);
  for (int i = 0; i < 100; ++i) things.watch({1.0, 1.0, 0.0}, line, kResolutionM);
  EXPECT_FALSE(things.trail(grid).empty());
  things.end_watch();
  EXPECT_TRUE(things.trail(grid).empty());
}

TEST(PassingThings, AWatchFromElsewhereDoesNotMakeWhatStoodPass) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).solid(2.0, 1.0, 2.1, 1.5, 0.0, 0.4).grid();
  PassingThings things = watched(1.0, 1.5, 100);
  things.begin_watch();
  for (int i = 0; i < 300; ++i) things.watch({1.0, 1.0, kPi}, {}, kResolutionM);
  things.end_watch();
  EXPECT_TRUE(things.trail(grid).empty());
}

}  // namespace
}  // namespace enfilade::explorer
