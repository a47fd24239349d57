// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "tests/unit/components/gridBuilder/box_room.hpp"
#include "tests/unit/components/gridBuilder/grid_builder_node_fixture.hpp"

namespace enfilade::grid_builder {
namespace {

TEST_F(GridBuilderNodeTest, TellsANewEpochWithAnEmptyChange) {
  start_sweeping();
  ASSERT_EQ(changes_->size(), 1u);
  EXPECT_EQ(changes_->front().tag, (ZoneTag{1, 1, 7}));
  EXPECT_EQ(changes_->front().sequence, 0u);
  EXPECT_TRUE(changes_->front().cells.empty());
  EXPECT_EQ(changes_->front().resolution_m, 0.05);
}

TEST_F(GridBuilderNodeTest, PublishesALineAtTheInstantThatCompletesIt) {
  start_sweeping();
  see(2.0);
  settle();
  ASSERT_EQ(changes_->size(), 2u);
  EXPECT_EQ(changes_->back().sequence, 1u);
  EXPECT_EQ(changes_->back().stamp_ns, from_seconds(2.0));
  EXPECT_EQ(changes_->back().cells.front(), (GridCell{40, 0, 12, CellState::kOccupied}));
  ASSERT_EQ(hits_->size(), 1u);
  EXPECT_EQ(hits_->front().tag, changes_->back().tag);
  EXPECT_EQ(hits_->front().hits.size(), 1u);
}

TEST_F(GridBuilderNodeTest, TakesOnlyLinesOfASweepWithTheBaseStanding) {
  start_sweeping();
  see(0.9);
  settle();
  EXPECT_EQ(changes_->size(), 1u);
  tell_pose(5.1, {}, 0.3);
  see(5.05);
  settle();
  EXPECT_EQ(changes_->size(), 1u);
  tell_sweep(SweepPhase::kDone, 1.0, 3.0);
  settle();
  see(2.9);
  see(3.1);
  settle();
  EXPECT_EQ(changes_->size(), 2u);
}

TEST_F(GridBuilderNodeTest, ClearsForANewZoneAndDropsOlderScans) {
  start_sweeping();
  see(2.0);
  settle();
  tell_zone(2, 3.0);
  settle();
  see(2.5);
  see(3.5);
  settle();
  ASSERT_EQ(changes_->size(), 4u);
  EXPECT_EQ((*changes_)[2].tag, (ZoneTag{2, 2, 7}));
  EXPECT_EQ((*changes_)[2].sequence, 0u);
  EXPECT_TRUE((*changes_)[2].cells.empty());
  EXPECT_EQ((*changes_)[3].sequence, 1u);
  EXPECT_EQ((*changes_)[3].stamp_ns, from_seconds(3.5));
  EXPECT_EQ((*changes_)[3].cells.size(), (*changes_)[1].cells.size());
}

TEST_F(GridBuilderNodeTest, ClearsWhenTheOdometryBootsAgain) {
  start_sweeping();
  see(2.0);
  settle();
  tell_sweep(SweepPhase::kSweeping, 1.0, 0.0, 8);
  settle();
  see(2.5);
  settle();
  ASSERT_EQ(changes_->size(), 3u);
  EXPECT_EQ(changes_->back().tag, (ZoneTag{1, 2, 8}));
  EXPECT_TRUE(changes_->back().cells.empty());
}

TEST_F(GridBuilderNodeTest, JoinsTheTwoCloudsOfALineWhetherTheyWaitOrNot) {
  start_sweeping();
  see(2.0);
  harness_->publish(topics::kPointsFree, PointCloud{from_seconds(2.0), "base_link", {{4.02F, 0.01F, 0.61F}}});
  settle();
  ASSERT_EQ(changes_->size(), 3u);
  EXPECT_EQ((*changes_)[2].sequence, 2u);
  for (const GridCell& cell : (*changes_)[2].cells) EXPECT_GT(cell.x, 40);
  EXPECT_EQ(hits_->size(), 1u);
}

TEST_F(GridBuilderNodeTest, AnswersWithASnapshotThatEqualsItsChanges) {
  start_sweeping();
  const BoxRoom room;
  std::map<CellIndex, CellState> replayed;
  for (int i = 0; i < 20; ++i) {
    PointCloud cloud{from_seconds(2.0 + 0.025 * i), "base_link", {}};
    cloud.points = room.scan(0, {0.1, 0.0, 0.6}, 0.1 * i, 361).hits;
    harness_->publish(topics::kPoints, cloud);
  }
  settle();
  for (const GridChange& change : *changes_) {
    for (const GridCell& c : change.cells) replayed[{c.x, c.y, c.z}] = c.state;
  }
  const auto reply = harness_->call(topics::kGridSnapshot, GridSnapshotRequest{});
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->snapshot.tag, changes_->back().tag);
  EXPECT_EQ(reply->snapshot.sequence, changes_->back().sequence);
  std::vector<GridCell> cells;
  for (const auto& [cell, state] : replayed) cells.push_back(to_grid_cell(cell, state));
  EXPECT_EQ(reply->snapshot.cells, cells);
}

TEST_F(GridBuilderNodeTest, ShowsItsGridToThoseWhoLookAndAtMostOnceAPeriod) {
  start_sweeping();
  const BoxRoom room;
  const auto see_room = [&](double stamp_s) {
    PointCloud cloud{from_seconds(stamp_s), "base_link", room.scan(0, {0.1, 0.0, 0.6}, stamp_s, 361).hits};
    harness_->publish(topics::kPoints, cloud);
  };
  for (int i = 0; i < 20; ++i) see_room(2.0 + 0.025 * i);
  harness_->advance_s(1.5);
  auto& octrees = harness_->collect(topics::kOctomap);
  auto& floors = harness_->collect(topics::kLocalMap);
  harness_->advance_s(3.0);
  ASSERT_EQ(octrees.size(), 1u);  // nothing has changed since
  ASSERT_EQ(floors.size(), 1u);
  EXPECT_EQ(octrees[0].frame_id, "zone");
  EXPECT_EQ(octrees[0].stamp_ns, from_seconds(2.475));
  EXPECT_EQ(octrees[0].resolution_m, 0.05);
  EXPECT_EQ(floors[0].frame_id, "zone");
  EXPECT_GT(std::ranges::count(floors[0].cells, OccupancyMap::kFree), 1000);
  for (int i = 0; i < 20; ++i) see_room(3.0 + 0.025 * i);
  harness_->advance_s(3.0);
  ASSERT_EQ(octrees.size(), 2u);
  EXPECT_GT(octrees[1].data.size(), octrees[0].data.size());
  tell_zone(2, 5.0);
  harness_->advance_s(3.0);
  EXPECT_EQ(octrees.size(), 2u);  // there is nothing to show yet
}

TEST_F(GridBuilderNodeTest, NeedsNothingButPointsAndTheMountWhenStationary) {
  GridBuilderConfig config;
  config.gate.stationary = true;
  start(config);
  see(2.0);
  settle();
  mount_laser();
  settle();
  ASSERT_EQ(changes_->size(), 2u);
  EXPECT_EQ(changes_->back().tag, (ZoneTag{1, 1, 0}));
  EXPECT_EQ(changes_->back().cells.size(), 39u);
}

TEST_F(GridBuilderNodeTest, SaysHowManyLinesItCouldNotUse) {
  GridBuilderConfig config;
  config.max_waiting_lines = 3;
  start(config);
  mount_laser();
  for (int i = 0; i < 5; ++i) see(1.0 + i);
  harness_->advance_s(0.2);
  ASSERT_FALSE(harness_->logged().empty());
  EXPECT_EQ(harness_->logged().back().text, "2 scan lines dropped: no odometry covers them");
}

}  // namespace
}  // namespace enfilade::grid_builder
