// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/convex_region.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "components/roomDetector/core/column_map.hpp"
#include "components/roomDetector/core/hit_map.hpp"

namespace enfilade::room_detector {
namespace {

/// Wedges, strips and boxes anywhere about the origin.
ConvexRegion random_region(std::mt19937& random) {
  std::uniform_real_distribution<double> metres(-2.0, 2.0), angle(-kPi, kPi);
  ConvexRegion region;
  for (auto lines = random() % (ConvexRegion::kMostLines + 1); lines > 0; --lines)
    region.cut({metres(random), metres(random)}, rotate(angle(random), {1.0, 0.0}));
  return region;
}

TEST(ConvexRegion, ContainsWhatLiesOnTheKeptSideOfAllLines) {
  ConvexRegion wedge;
  wedge.cut({1.0, 0.0}, {1.0, 0.0}).cut({0.0, 2.0}, {0.0, -1.0});
  EXPECT_TRUE(wedge.contains({1.5, 1.5}));
  EXPECT_FALSE(wedge.contains({0.5, 1.5}));
  EXPECT_FALSE(wedge.contains({1.5, 2.5}));
  EXPECT_TRUE(wedge.may_meet({0.5, 1.5}, 0.6));
  EXPECT_FALSE(wedge.may_meet({0.5, 1.5}, 0.4));
}

TEST(HitMap, VisitsWithinARegionWhatGoingThroughAllWouldFind) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> metres(-4.0F, 4.0F);
  std::vector<CellHit> hits;
  for (int i = 0; i < 3000; ++i) hits.push_back({metres(random), metres(random), 1.0F, 1});
  HitMap map;
  map.add(hits, 0.05);
  const Pose2 T_map_hits{0.3, -0.2, 0.4};
  int visited = 0;
  for (int i = 0; i < 50; ++i) {
    const ConvexRegion region = random_region(random);
    double expected = 0.0, found = 0.0;
    for (const WallPoint& p : map.points(0, kLevels))
      if (region.contains(T_map_hits * p.position)) expected += p.weight;
    map.visit_within(region, T_map_hits, [&](const Point2& at, double count) {
      EXPECT_TRUE(region.contains(at));
      found += count;
      return true;
    });
    EXPECT_EQ(found, expected);
    visited += static_cast<int>(found);
  }
  EXPECT_GT(visited, 10000);
}

TEST(HitMap, StopsVisitingWhenToldTo) {
  HitMap map;
  for (float x = -3.0F; x < 3.0F; x += 0.1F) map.add({{x, 0.0F, 1.0F, 1}}, 0.05);
  int visits = 0;
  map.visit_within({}, {}, [&](const Point2&, double) { return ++visits < 5; });
  EXPECT_EQ(visits, 5);
}

TEST(ColumnMap, CountsWithinARegionWhatGoingThroughAllWouldFind) {
  std::mt19937 random(8);
  std::vector<GridCell> cells;
  for (int i = 0; i < 3000; ++i) {
    const auto below = [&](int most) { return static_cast<int>(random() % static_cast<unsigned>(most)); };
    const auto at = [&] { return static_cast<std::int16_t>(below(160) - 80); };
    cells.push_back({at(), at(), static_cast<std::int16_t>(below(20)), static_cast<CellState>(below(3))});
  }
  ColumnMap map;
  map.clear(0.05);
  map.apply(cells);
  const Levels counted = level_range(level_of(kCountedFrom_m, 0.05), kLevels);
  int visited = 0;
  for (int i = 0; i < 50; ++i) {
    const ConvexRegion region = random_region(random);
    int occupied = 0, free = 0, occupied_found = 0, free_found = 0;
    for (const Column& column : map.columns()) {
      if (!region.contains(map.centre(column))) continue;
      occupied += count_of(column.occupied & counted);
      free += count_of(column.free & counted);
    }
    map.visit_within(region, [&](const ColumnMap::Counts& counts) {
      occupied_found += counts.occupied;
      free_found += counts.free;
    });
    EXPECT_EQ(occupied_found, occupied);
    EXPECT_EQ(free_found, free);
    visited += free;
  }
  EXPECT_GT(visited, 3000);
}

}  // namespace
}  // namespace enfilade::room_detector
