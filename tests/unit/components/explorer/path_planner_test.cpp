// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/path_planner.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/explorer/synthetic_room.hpp"

namespace enfilade::explorer {
namespace {

double least_clearance(const FloorMap& map, const Path& path) {
  double least_m = 10.0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    for (double t = 0.0; t <= 1.0; t += 0.01) {
      const Point2 p = path.points[i - 1] + t * (path.points[i] - path.points[i - 1]);
      least_m = std::min(least_m, map.to_obstacle_m(map.cell_at(p)));
    }
  }
  return least_m;
}

TEST(PathPlanner, GoesRoundFurnitureWithRoomForTheRobot) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).solid(1.8, 0, 2.2, 3.0, 0.0, 0.5).grid();
  const FloorMap map(grid, {}, {});
  const auto path = Reach(map, {}, {0.6, 0.6}).path_to({3.4, 0.6});
  ASSERT_TRUE(path);
  EXPECT_GE(least_clearance(map, *path), 0.27);
  EXPECT_GT(path->length_m, 5.0);
  EXPECT_LT(path->length_m, 8.0);
  EXPECT_EQ(path->points.front(), Point2(0.6, 0.6));
  EXPECT_EQ(path->points.back(), Point2(3.4, 0.6));
}

TEST(PathPlanner, GoesStraightWhereNothingIsInTheWay) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).grid();
  const FloorMap map(grid, {}, {});
  const auto path = Reach(map, {}, {0.8, 0.9}).path_to({3.1, 2.7});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points.size(), 2u);
}

TEST(PathPlanner, FindsNoWayThroughAGapThatIsTooNarrow) {
  const auto gap = [](double width) {
    auto room = SyntheticRoom().room(0, 0, 4, 4).solid(2.0, 0, 2.1, 4.0);
    return room.free(2.0, 2.0 - width / 2, 2.1, 2.0 + width / 2).grid();
  };
  const auto narrow = gap(0.4), wide = gap(0.8);
  const FloorMap narrow_map(narrow, {}, {}), wide_map(wide, {}, {});
  EXPECT_FALSE(Reach(narrow_map, {}, {1, 2}).path_to({3, 2}));
  EXPECT_TRUE(Reach(wide_map, {}, {1, 2}).path_to({3, 2}));
}

TEST(PathPlanner, DoesNotCrossUnexploredFloor) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).unexplored(1.8, 0, 2.4, 4).grid();
  const FloorMap map(grid, {}, {});
  const Reach reach(map, {}, {0.8, 2});
  EXPECT_FALSE(reach.path_to({3.2, 2}));
  const auto nearest = reach.nearest({2.0, 2.0}, 1.0);
  ASSERT_TRUE(nearest);
  EXPECT_NEAR(nearest->x(), 1.58, 0.06);
}

TEST(PathPlanner, SingleUnexploredCellsDoNotBarTheWay) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 1).unexplored(2.0, 0.5, 2.05, 0.55).grid();
  const FloorMap map(grid, {}, {});
  EXPECT_TRUE(Reach(map, {}, {0.8, 0.5}).path_to({3.2, 0.5}));
}

TEST(PathPlanner, LeavesAPlaceTooNearToAWallWithoutGoingNearer) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).grid();
  const FloorMap map(grid, {}, {});
  const Point2 start{0.22, 2.0};
  const double clearance_m = map.to_obstacle_m(map.cell_at(start));
  const auto path = Reach(map, {}, start).path_to({2, 2});
  ASSERT_TRUE(path);
  EXPECT_GE(least_clearance(map, *path), clearance_m - 0.01);
}

TEST(PathPlanner, WhatWasSeenWhereTheRobotStandsIsTheRobot) {
  const auto grid =
      SyntheticRoom().room(0, 0, 4, 4).solid(1.65, 1.5, 1.7, 1.55).solid(1.8, 1.5, 1.85, 1.55).grid();
  const FloorMap map(grid, {.trodden = {{1.5, 1.5}}, .obstacles = {}}, {});
  EXPECT_EQ(map.floor(map.cell_at({1.67, 1.52})), Floor::kFree);
  EXPECT_EQ(map.floor(map.cell_at({1.82, 1.52})), Floor::kObstacle);
}

TEST(PathPlanner, WhereTheRobotHasBeenIsFree) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).unexplored(1, 1, 2, 2).grid();
  const FloorMap without(grid, {}, {}), with(grid, {.trodden = {{1.5, 1.5}}, .obstacles = {}}, {});
  EXPECT_EQ(without.floor(without.cell_at({1.5, 1.5})), Floor::kUnexplored);
  EXPECT_EQ(with.floor(with.cell_at({1.5, 1.5})), Floor::kFree);
}

}  // namespace
}  // namespace enfilade::explorer
