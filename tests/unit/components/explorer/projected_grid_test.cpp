// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/projected_grid.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/explorer/synthetic_room.hpp"

namespace enfilade::explorer {
namespace {

TEST(ProjectedGrid, ColumnWithSomethingAtTheHeightOfTheRobotIsAnObstacle) {
  const auto grid = SyntheticRoom().free(0, 0, 1, 1).solid(0.5, 0.5, 0.6, 0.6, 0.1, 0.15).grid();
  EXPECT_EQ(grid.floor(grid.cell_at({0.52, 0.52})), Floor::kObstacle);
  EXPECT_EQ(grid.floor(grid.cell_at({0.22, 0.52})), Floor::kFree);
}

TEST(ProjectedGrid, FloorItselfAndWhatHangsHighAreNoObstacles) {
  const auto grid =
      SyntheticRoom().free(0, 0, 1, 1).solid(0, 0, 1, 1, 0.0, 0.05).solid(0, 0, 1, 1, 0.75, 0.8).grid();
  EXPECT_EQ(grid.floor(grid.cell_at({0.5, 0.5})), Floor::kFree);
}

TEST(ProjectedGrid, FloorSeenFreeOnlyHighAboveStaysUnexplored) {
  const auto grid = SyntheticRoom().free(0, 0, 1, 1, 0.4, 2.0).grid();
  EXPECT_EQ(grid.floor(grid.cell_at({0.5, 0.5})), Floor::kUnexplored);
  EXPECT_EQ(grid.floor({1000, 1000}), Floor::kUnexplored);
}

TEST(ProjectedGrid, ChangesInPiecesGiveWhatOneMessageGives) {
  const auto all = SyntheticRoom().room(-1, -2, 3, 2).solid(1, 1, 1.5, 1.5, 0.0, 0.8);
  const ProjectedGrid whole = all.grid();
  ProjectedGrid pieces{ProjectedGridConfig{}};
  for (const GridCell& cell : all.cells()) pieces.apply(0.05, {cell});
  for (int x = -50; x < 90; ++x) {
    for (int y = -60; y < 60; ++y) ASSERT_EQ(pieces.floor({x, y}), whole.floor({x, y})) << x << ", " << y;
  }
}

TEST(ProjectedGrid, CellsThatVanishNoLongerStandInTheWay) {
  ProjectedGrid grid = SyntheticRoom().free(0, 0, 1, 1).solid(0.5, 0.5, 0.6, 0.6).grid();
  grid.apply(0.05, SyntheticRoom().free(0.5, 0.5, 0.6, 0.6).cells());
  EXPECT_EQ(grid.floor(grid.cell_at({0.52, 0.52})), Floor::kFree);
  grid.clear();
  EXPECT_TRUE(grid.empty());
}

TEST(ProjectedGrid, CountsTheStatesOfABand) {
  const auto grid = SyntheticRoom().free(0, 0, 1, 1, 0.0, 1.0).solid(0, 0, 1, 1, 1.0, 1.5).grid();
  const auto count = grid.count(grid.cell_at({0.5, 0.5}), 0.5, 2.0);
  EXPECT_EQ(count.free, 10);
  EXPECT_EQ(count.occupied, 10);
  EXPECT_EQ(count.unexplored, 10);
}

}  // namespace
}  // namespace enfilade::explorer
