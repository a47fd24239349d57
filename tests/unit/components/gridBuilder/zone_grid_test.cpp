// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/zone_grid.hpp"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "tests/unit/components/gridBuilder/box_room.hpp"

namespace enfilade::grid_builder {
namespace {

const Eigen::Vector3d kSensor{0.1037, 0.0211, 0.6013};
const Point3f kOrigin{0.025F, 0.025F, 0.625F};

/// One beam along x from kOrigin to the cell x_cell.
Point3f along_x(int x_cell) { return {(static_cast<float>(x_cell) + 0.5F) * 0.05F, 0.025F, 0.625F}; }
CellIndex cell_along_x(int x) { return {x, 0, 12}; }
ScanLine hit_line(StampNs stamp_ns, int x_cell) { return {stamp_ns, kOrigin, {along_x(x_cell)}, {}}; }

TEST(ZoneGrid, CarvesUpToAHitAndKnowsNothingBehindIt) {
  ZoneGrid grid({});
  grid.insert(hit_line(1, 20));
  EXPECT_EQ(grid.state(cell_along_x(0)), CellState::kFree);
  EXPECT_EQ(grid.state(cell_along_x(19)), CellState::kFree);
  EXPECT_EQ(grid.state(cell_along_x(20)), CellState::kOccupied);
  EXPECT_EQ(grid.state(cell_along_x(21)), CellState::kUnexplored);
  EXPECT_EQ(grid.known_cells().size(), 21u);
}

TEST(ZoneGrid, LetsHitsWinOverMissesOfTheSameLine) {
  ZoneGrid grid({});
  grid.insert({1, kOrigin, {along_x(30), along_x(20)}, {along_x(40)}});
  EXPECT_EQ(grid.state(cell_along_x(20)), CellState::kOccupied);
  EXPECT_EQ(grid.state(cell_along_x(30)), CellState::kOccupied);
  EXPECT_NEAR(grid.probability(cell_along_x(20)).value(), 0.7, 1e-6);
}

TEST(ZoneGrid, CountsEachCellOncePerLine) {
  ZoneGrid grid({});
  grid.insert({1, kOrigin, {along_x(20), along_x(20), along_x(20)}, {}});
  EXPECT_NEAR(grid.probability(cell_along_x(20)).value(), 0.7, 1e-6);
  EXPECT_NEAR(grid.probability(cell_along_x(5)).value(), 0.4, 1e-6);
}

TEST(ZoneGrid, TakesTheTwoCloudsOfOneLineInAnyOrderAsOneLine) {
  ZoneGrid together({}), apart({}), reversed({});
  const ScanLine hits{1, kOrigin, {along_x(20)}, {}}, free_ends{1, kOrigin, {}, {along_x(40)}};
  together.insert({1, kOrigin, hits.hits, free_ends.free_ends});
  apart.insert(hits);
  apart.insert(free_ends);
  reversed.insert(free_ends);
  reversed.insert(hits);
  for (int x = 0; x < 40; ++x) {
    const CellIndex cell = cell_along_x(x);
    EXPECT_EQ(apart.probability(cell), together.probability(cell)) << x;
    EXPECT_NEAR(reversed.probability(cell).value(), together.probability(cell).value(), 1e-6) << x;
  }
}

TEST(ZoneGrid, GrowsMoreCertainOfAPointThatIsSeenAgain) {
  ZoneGrid grid({});
  double before = 0.5;
  for (StampNs stamp = 1; stamp <= 4; ++stamp) {
    grid.insert(hit_line(stamp, 20));
    EXPECT_GT(grid.probability(cell_along_x(20)).value(), before);
    before = grid.probability(cell_along_x(20)).value();
  }
}

TEST(ZoneGrid, ForgetsAChairThatWasMovedAway) {
  ZoneGrid grid({});
  for (StampNs stamp = 1; stamp <= 10; ++stamp) grid.insert(hit_line(stamp, 20));
  EXPECT_NEAR(grid.probability(cell_along_x(20)).value(), 0.97, 1e-6);
  int lines_until_free = 0;
  double before = 1.0;
  while (grid.state(cell_along_x(20)) == CellState::kOccupied && lines_until_free < 100) {
    grid.insert(hit_line(100 + ++lines_until_free, 40));
    EXPECT_LT(grid.probability(cell_along_x(20)).value(), before);
    before = grid.probability(cell_along_x(20)).value();
  }
  EXPECT_EQ(lines_until_free, 9);  // ln(0.97/0.03) / ln(0.6/0.4) = 8.6
}

/// The occupied cells of a column between two heights as a reader of the changes counts them.
struct ColumnCount {
  int occupied = 0;

  void follow(const LineUpdate& update, int x, int from_z, int to_z) {
    for (const GridCell& c : update.changes) {
      if (c.x != x || c.y != 0 || c.z < from_z || c.z >= to_z) continue;
      const bool was = occupied_.contains(c.z), is = c.state == CellState::kOccupied;
      occupied += is - was;
      if (is) occupied_.insert(c.z);
      if (!is) occupied_.erase(c.z);
    }
  }

 private:
  std::set<int> occupied_;
};

/// Level beams along x in each of the layers 4 … 37, all of one line, that end at `x_cell`.
template <class Take>
void see_at_all_heights(ZoneGrid& grid, StampNs stamp_ns, int x_cell, Take&& take) {
  for (int z = 4; z < 38; ++z) {
    const float z_m = (static_cast<float>(z) + 0.5F) * 0.05F;
    take(grid.insert({stamp_ns, {kOrigin.x_m, kOrigin.y_m, z_m}, {{along_x(x_cell).x_m, 0.025F, z_m}}, {}}));
  }
}

TEST(ZoneGrid, ForgetsAPersonWhoPassedThroughTheRoom) {
  ZoneGrid grid({});
  ColumnCount person, wall;
  const auto see = [&](StampNs stamp_ns, int x_cell) {
    see_at_all_heights(grid, stamp_ns, x_cell, [&](const LineUpdate& update) {
      person.follow(update, 20, 4, 38);
      wall.follow(update, 60, 4, 38);
    });
  };
  StampNs stamp_ns = 0;
  for (int i = 0; i < 5; ++i) see(++stamp_ns, 60);
  for (int i = 0; i < 3; ++i) see(++stamp_ns, 20);
  EXPECT_EQ(person.occupied, 34);
  EXPECT_EQ(wall.occupied, 34) << "what a person hides is not gone";
  for (int i = 0; i < 9; ++i) see(++stamp_ns, 60);
  EXPECT_EQ(person.occupied, 0);
  EXPECT_EQ(wall.occupied, 34);
}

TEST(ZoneGrid, FollowsADoorThatIsOpenedAndClosed) {
  ZoneGrid grid({});
  ColumnCount leaf;
  StampNs stamp_ns = 0;
  const auto see = [&](int lines, int x_cell) {
    for (int i = 0; i < lines; ++i)
      see_at_all_heights(grid, ++stamp_ns, x_cell,
                         [&](const LineUpdate& update) { leaf.follow(update, 30, 4, 38); });
  };
  see(10, 30);
  EXPECT_EQ(leaf.occupied, 34) << "closed";
  see(9, 60);
  EXPECT_EQ(leaf.occupied, 0) << "opened";
  see(3, 30);
  EXPECT_EQ(leaf.occupied, 34) << "closed again";
}

TEST(ZoneGrid, CarvesButDoesNotHitBeyondTheMaximalRange) {
  ZoneGrid grid({.max_range_m = 1.0});
  const LineUpdate update = grid.insert(hit_line(1, 60));
  EXPECT_TRUE(update.hits.empty());
  EXPECT_EQ(grid.state(cell_along_x(19)), CellState::kFree);
  EXPECT_EQ(grid.state(cell_along_x(21)), CellState::kUnexplored);
  EXPECT_EQ(grid.state(cell_along_x(60)), CellState::kUnexplored);
}

TEST(ZoneGrid, CarvesToAFreeEndWithoutAHit) {
  ZoneGrid grid({});
  const LineUpdate update = grid.insert({1, kOrigin, {}, {along_x(40)}});
  EXPECT_TRUE(update.hits.empty());
  EXPECT_EQ(update.changes.size(), 40u);
  for (const GridCell& cell : update.changes) EXPECT_EQ(cell.state, CellState::kFree);
}

TEST(ZoneGrid, KeepsToItsHeights) {
  ZoneGrid grid({.max_height_m = 2.0});
  const LineUpdate update = grid.insert({1, kOrigin, {{0.025F, 0.025F, 2.5F}, {0.025F, 0.025F, -0.4F}}, {}});
  EXPECT_TRUE(update.hits.empty());
  EXPECT_EQ(grid.state({0, 0, 39}), CellState::kFree);
  EXPECT_EQ(grid.state({0, 0, 40}), CellState::kUnexplored);
  EXPECT_EQ(grid.state({0, 0, -2}), CellState::kFree);
  EXPECT_EQ(grid.state({0, 0, -3}), CellState::kUnexplored);
}

TEST(ZoneGrid, ChangesNoStateWhenALineIsRepeated) {
  ZoneGrid grid({});
  EXPECT_FALSE(grid.insert(BoxRoom{}.scan(1, kSensor, 0.4)).changes.empty());
  for (StampNs stamp = 2; stamp < 20; ++stamp) {
    EXPECT_TRUE(grid.insert(BoxRoom{}.scan(stamp, kSensor, 0.4)).changes.empty());
  }
}

TEST(ZoneGrid, TellsInItsChangesAllThatItKnows) {
  std::mt19937 engine(5);
  const BoxRoom before = BoxRoom::random(engine), after = BoxRoom::random(engine);
  ZoneGrid grid({});
  std::map<CellIndex, CellState> replayed;
  for (int i = 0; i < 60; ++i) {
    const LineUpdate update =
        grid.insert((i < 30 ? before : after).scan(i + 1, kSensor, radians(6.0 * (i % 30)), 361));
    for (const GridCell& c : update.changes) replayed[{c.x, c.y, c.z}] = c.state;
  }
  std::vector<GridCell> cells;
  for (const auto& [cell, state] : replayed) cells.push_back(to_grid_cell(cell, state));
  EXPECT_EQ(grid.known_cells(), cells);
}

TEST(ZoneGrid, MovesItsCellsWhenTheWorldMovesByWholeCells) {
  ZoneGrid grid({.resolution_m = 0.0625}), moved({.resolution_m = 0.0625});
  // A power of two as the side of a cell keeps the shift exact.
  ScanLine line = BoxRoom{}.scan(1, {0.1037, 0.0211, 0.6013}, 0.4);
  const auto round = [](Point3f& p) {
    const auto dyadic = [](float v) { return std::round(v * 4096.0F) / 4096.0F; };
    p = {dyadic(p.x_m), dyadic(p.y_m), dyadic(p.z_m)};
  };
  round(line.origin);
  for (Point3f& p : line.hits) round(p);
  ScanLine shifted = line;
  shifted.origin.x_m += 16 * 0.0625F;
  for (Point3f& p : shifted.hits) p.x_m += 16 * 0.0625F;
  std::vector<GridCell> expected = grid.insert(line).changes;
  for (GridCell& cell : expected) cell.x = static_cast<std::int16_t>(cell.x + 16);
  EXPECT_EQ(moved.insert(shifted).changes, expected);
}

TEST(ZoneGrid, GivesTheMeanReturnOfEachCell) {
  ZoneGrid grid({});
  const LineUpdate update =
      grid.insert({1, kOrigin, {{1.01F, 0.01F, 0.61F}, {0.51F, 0.01F, 0.61F}, {1.03F, 0.03F, 0.63F}}, {}});
  ASSERT_EQ(update.hits.size(), 2u);
  EXPECT_EQ(update.hits[0], (CellHit{0.51F, 0.01F, 0.61F, 1}));
  EXPECT_EQ(update.hits[1].count, 2);
  EXPECT_NEAR(update.hits[1].x_m, 1.02, 1e-6);
  EXPECT_NEAR(update.hits[1].z_m, 0.62, 1e-6);
}

TEST(ZoneGrid, IgnoresPointsThatAreNoNumbersOrOutOfTheWorld) {
  ZoneGrid grid({});
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(grid.insert({1, kOrigin, {{nan, 0, 1}, {inf, 0, 1}}, {{0, nan, 1}}}).changes.empty());
  EXPECT_TRUE(grid.insert({2, {1e9F, 0, 1}, {{1e9F, 1, 1}}, {}}).changes.empty());
}

TEST(ZoneGrid, LeavesAloneWhatItsCellsCannotCount) {
  ZoneGrid grid({.resolution_m = 0.01, .max_range_m = 100.0});
  for (const float side : {1.0F, -1.0F}) {
    const Point3f counted{side * 227.6F, 0.0F, 1.0F}, beyond{side * 227.7F, 0.0F, 1.0F};
    const auto line = [&](StampNs stamp_ns, const Point3f& origin) {
      return ScanLine{stamp_ns, origin, {{origin.x_m + side * 99.9F, 0.0F, 1.0F}}, {}};
    };
    const LineUpdate update = grid.insert(line(side > 0 ? 1 : 3, counted));
    EXPECT_GT(update.changes.size(), 9900u);
    for (const GridCell& cell : update.changes) ASSERT_GT(static_cast<float>(cell.x) * side, 22000.0F);
    EXPECT_TRUE(grid.insert(line(side > 0 ? 2 : 4, beyond)).changes.empty());
  }
}

TEST(ZoneGrid, StopsGrowingAtItsMemoryLimitAndSaysSo) {
  ZoneGrid grid({.max_memory_mb = 1});
  std::size_t lost = 0;
  for (int i = 0; i < 36; ++i)
    lost += grid.insert(BoxRoom{}.scan(i + 1, kSensor, radians(5.0 * i))).cells_without_memory;
  EXPECT_GT(lost, 0u);
  EXPECT_EQ(grid.tile_count(), 128u);
}

TEST(ZoneGrid, RefusesAConfigurationThatMakesNoSense) {
  EXPECT_THROW(ZoneGrid({.prob_hit = 0.4}), std::invalid_argument);
  EXPECT_THROW(ZoneGrid({.clamp_max = 0.4}), std::invalid_argument);
  EXPECT_THROW(ZoneGrid({.min_height_m = 4.0}), std::invalid_argument);
}

}  // namespace
}  // namespace enfilade::grid_builder
