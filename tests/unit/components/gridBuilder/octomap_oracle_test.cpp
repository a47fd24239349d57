// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include "components/gridBuilder/core/octree.hpp"
#include "tests/unit/components/gridBuilder/box_room.hpp"

namespace enfilade::grid_builder {
namespace {

void insert_into(octomap::OcTree& tree, const ScanLine& line, double max_range_m) {
  octomap::Pointcloud cloud;
  for (const Point3f& p : line.hits) cloud.push_back(p.x_m, p.y_m, p.z_m);
  tree.insertPointCloud(cloud, {line.origin.x_m, line.origin.y_m, line.origin.z_m}, max_range_m);
}

CellState state_in(const octomap::OcTree& tree, int x, int y, int z) {
  const auto key = [](int i) { return static_cast<octomap::key_type>(i + 32768); };
  const octomap::OcTreeNode* node = tree.search(octomap::OcTreeKey(key(x), key(y), key(z)));
  if (!node) return CellState::kUnexplored;
  return tree.isNodeOccupied(node) ? CellState::kOccupied : CellState::kFree;
}

struct Comparison {
  int known = 0, occupied = 0, different = 0;
};

/// Every cell of a box that holds all rooms of these tests.
Comparison compare(const ZoneGrid& grid, const octomap::OcTree& tree) {
  Comparison result;
  for (int x = -76; x < 76; ++x) {
    for (int y = -76; y < 76; ++y) {
      for (int z = -2; z < 70; ++z) {
        const CellState expected = state_in(tree, x, y, z);
        result.known += expected != CellState::kUnexplored;
        result.occupied += expected == CellState::kOccupied;
        result.different += grid.state({x, y, z}) != expected;
      }
    }
  }
  return result;
}

const Eigen::Vector3d kOracleSensor{0.1037, 0.0211, 0.6013};

class OctoMapOracle : public testing::TestWithParam<int> {};

/// OctoMap computes beams in single precision, so a beam that grazes an edge of a cell may go round the other
/// side of it: a few in a million steps.
TEST_P(OctoMapOracle, GivesEveryCellTheSameStateWhenFurnitureMoves) {
  std::mt19937 engine(GetParam());
  const BoxRoom before = BoxRoom::random(engine);
  BoxRoom after = before;
  after.furniture = BoxRoom::random(engine).furniture;
  const ZoneGridConfig config{.max_range_m = 3.5};
  ZoneGrid grid(config);
  const auto tree = make_octree(config);
  for (int i = 0; i < 80; ++i) {
    const ScanLine line =
        (i < 40 ? before : after).scan(i + 1, kOracleSensor, radians(-90.0 + 4.3 * (i % 40)), 271);
    grid.insert(line);
    insert_into(*tree, line, config.max_range_m);
  }
  const Comparison result = compare(grid, *tree);
  EXPECT_GT(result.occupied, 500);
  RecordProperty("different", result.different);
  RecordProperty("known", result.known);
  EXPECT_LE(result.different, result.known / 20000) << "of " << result.known << " known cells";
}

INSTANTIATE_TEST_SUITE_P(RandomRooms, OctoMapOracle, testing::Range(1, 5));

/// Where a beam hits a cell as often as it passes, hardly two histories give the same sum.
TEST(Octree, GivesACellTheSameLogOddsAfterAnyHistory) {
  ZoneGrid grid({});
  const auto tree = make_octree({});
  const Point3f origin{0.025F, 0.025F, 0.625F}, at{1.025F, 0.025F, 0.625F}, beyond{2.025F, 0.025F, 0.625F};
  std::mt19937 engine(1);
  std::set<float> sums;
  for (int i = 0; i < 5000; ++i) {
    const bool is_hit = engine() % 16 < 5;
    grid.insert({i + 1, origin, {is_hit ? at : beyond}, {}});
    sums.insert(tree->updateNode(octomap::point3d(at.x_m, at.y_m, at.z_m), is_hit)->getLogOdds());
    float log_odds = 0.0F;
    grid.for_each_known([&](const CellIndex& cell, float known) {
      if (cell == grid.cell_at(at)) log_odds = known;
    });
    ASSERT_EQ(log_odds, tree->search(at.x_m, at.y_m, at.z_m)->getLogOdds()) << "line " << i;
  }
  EXPECT_GT(sums.size(), 500u);  // more than a byte can tell
}

TEST(Octree, HoldsTheSameCellsAndCertaintiesAsTheGrid) {
  ZoneGrid grid({});
  for (int i = 0; i < 10; ++i) grid.insert(BoxRoom{}.scan(i + 1, kOracleSensor, radians(9.0 * i), 541));
  const auto tree = to_octree(grid);
  const Comparison result = compare(grid, *tree);
  EXPECT_EQ(result.different, 0);
  EXPECT_EQ(static_cast<std::size_t>(result.known), grid.known_cells().size());
  const CellIndex cell = grid.cell_at({0.5F, 0.0211F, 0.6013F});
  const auto* node = tree->search(octomap::point3d(0.5F, 0.0211F, 0.6013F));
  ASSERT_TRUE(node);
  EXPECT_NEAR(node->getOccupancy(), grid.probability(cell).value(), 1e-6);
}

}  // namespace
}  // namespace enfilade::grid_builder
