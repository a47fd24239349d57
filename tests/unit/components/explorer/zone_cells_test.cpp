// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/node/zone_cells.hpp"

#include <gtest/gtest.h>

namespace enfilade::explorer {
namespace {

constexpr ZoneTag kCellsTag{1, 7, 2};

GridChange change(std::uint64_t sequence, std::int16_t x, ZoneTag tag = kCellsTag) {
  return {.tag = tag, .sequence = sequence, .resolution_m = 0.05, .cells = {{x, 0, 5, CellState::kOccupied}}};
}

TEST(ZoneCells, FollowsAnEpochFromItsFirstMessage) {
  ZoneCells cells{ProjectedGridConfig{}};
  EXPECT_FALSE(cells.tag());
  EXPECT_EQ(cells.take({.tag = kCellsTag, .sequence = 0}), ZoneCells::Verdict::kTaken);
  EXPECT_EQ(cells.take(change(1, 3)), ZoneCells::Verdict::kTaken);
  EXPECT_EQ(cells.tag(), kCellsTag);
  EXPECT_EQ(cells.grid().floor({3, 0}), Floor::kObstacle);
}

TEST(ZoneCells, AMissedMessageCallsForASnapshot) {
  ZoneCells cells{ProjectedGridConfig{}};
  cells.take({.tag = kCellsTag, .sequence = 0});
  EXPECT_EQ(cells.take(change(2, 3)), ZoneCells::Verdict::kNeedsSnapshot);
  EXPECT_FALSE(cells.tag());
  cells.take_snapshot(change(4, 9));
  EXPECT_EQ(cells.tag(), kCellsTag);
  EXPECT_EQ(cells.grid().floor({9, 0}), Floor::kObstacle);
  EXPECT_EQ(cells.grid().floor({3, 0}), Floor::kUnexplored);
  EXPECT_EQ(cells.take(change(4, 1)), ZoneCells::Verdict::kTaken);  // is in the snapshot already
  EXPECT_EQ(cells.grid().floor({1, 0}), Floor::kUnexplored);
  EXPECT_EQ(cells.take(change(5, 1)), ZoneCells::Verdict::kTaken);
  EXPECT_EQ(cells.grid().floor({1, 0}), Floor::kObstacle);
}

TEST(ZoneCells, ANewEpochEmptiesTheGrid) {
  ZoneCells cells{ProjectedGridConfig{}};
  cells.take({.tag = kCellsTag, .sequence = 0});
  cells.take(change(1, 3));
  cells.take({.tag = {2, 8, 2}, .sequence = 0});
  EXPECT_EQ(cells.tag(), (ZoneTag{2, 8, 2}));
  EXPECT_TRUE(cells.grid().empty());
}

}  // namespace
}  // namespace enfilade::explorer
