// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/node/grid_builder_node.hpp"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "tests/support/node_harness.hpp"
#include "tests/unit/components/gridBuilder/box_room.hpp"

namespace enfilade::grid_builder {
namespace {

using Harness = NodeHarness<GridBuilderNode, GridBuilderConfig>;

/// Plays laser3D, motorControl and topoGraph round one node.
class GridBuilderNodeTest : public testing::Test {
 protected:
  GridBuilderNodeTest() { set_process_run_id(""); }

  void start(const GridBuilderConfig& config = {}) {
    harness_ = std::make_unique<Harness>("gridBuilder", config);
    changes_ = &harness_->collect(topics::kGridChange);
    hits_ = &harness_->collect(topics::kScanHits);
    harness_->node();
  }

  void mount_laser() {
    TransformList mount;
    mount.transforms.push_back({0, "base_link", "laser", {.x_m = 0.1, .z_m = 0.6}});
    harness_->publish(topics::kTfStatic, mount);
  }

  void tell_zone(std::uint32_t id, double valid_from_s = 0.0) {
    CurrentZone zone;
    zone.zone_id = id;
    zone.valid_from_ns = from_seconds(valid_from_s);
    harness_->publish(topics::kCurrentZone, zone);
    harness_->publish(topics::kTf, TransformList{{{harness_->now_ns(), "map", "odom", {}}}});
  }

  void tell_sweep(SweepPhase phase, double start_s, double end_s = 0.0, std::uint32_t boot = 7) {
    harness_->publish(topics::kMotorState, MotorState{harness_->now_ns(), boot, 1, phase,
                                                      from_seconds(start_s), from_seconds(end_s), false});
  }

  void tell_pose(double stamp_s, const Pose2& T_odom_base = {}, double linear_m_s = 0.0) {
    harness_->publish(topics::kOdom,
                      Odometry{from_seconds(stamp_s), to_transform3(T_odom_base), linear_m_s, 0.0});
  }

  /// One return straight ahead, `range_m` from the base.
  void see(double stamp_s, float range_m = 2.02F) {
    harness_->publish(topics::kPoints,
                      PointCloud{from_seconds(stamp_s), "base_link", {{range_m, 0.01F, 0.61F}}});
  }

  /// Zone 1, sweeping from t = 1 s on, standing at the origin until t = 5 s.
  void start_sweeping() {
    start();
    mount_laser();
    tell_zone(1);
    tell_sweep(SweepPhase::kSweeping, 1.0);
    for (int i = 0; i <= 50; ++i) tell_pose(0.1 * i);
    settle();
  }

  /// Delivers what has been published at this very instant, writer by writer.
  void settle() { harness_->advance_s(0.0); }

  std::unique_ptr<Harness> harness_;
  std::vector<GridChange>* changes_ = nullptr;
  std::vector<ScanHits>* hits_ = nullptr;
};

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

TEST_F(GridBuilderNodeTest, TellsWhereTheZoneLiesInOdometryWhateverElseHappens) {
  GridBuilderConfig config;
  config.registration.register_scans = true;
  start(config);
  auto& tf = harness_->collect(topics::kTf);
  tell_zone(1);
  harness_->advance_s(0.35);
  ASSERT_FALSE(tf.empty());
  const auto T_zone_odom = find_zone_odom(tf.back());
  ASSERT_TRUE(T_zone_odom);
  EXPECT_EQ(*T_zone_odom, Pose2{});
}

TEST_F(GridBuilderNodeTest, LearnsFromTheMapHowFarOdometryHadDriftedBeforeItWasStarted) {
  const Pose2 T_map_zone{3.0, 1.0, 0.4}, T_zone_odom{0.3, -0.2, radians(90.0)};
  start();
  mount_laser();
  CurrentZone zone{.zone_id = 4};
  zone.T_map_zone = T_map_zone;
  harness_->publish(topics::kCurrentZone, zone);
  tell_sweep(SweepPhase::kSweeping, 1.0);
  for (int i = 0; i <= 50; ++i) tell_pose(0.1 * i);
  see(2.0);
  settle();
  EXPECT_TRUE(hits_->empty()) << "a line waits until its place is known";

  harness_->publish_as("topoGraph", topics::kTf,
                       TransformList{{{0, "map", "odom", to_transform3(T_map_zone * T_zone_odom)}}});
  settle();
  ASSERT_EQ(hits_->size(), 1u);
  const Pose2 off = T_zone_odom.inverse() * hits_->front().T_zone_base;
  EXPECT_NEAR(off.translation().norm() + std::abs(off.yaw_rad), 0.0, 1e-9);
}

TEST_F(GridBuilderNodeTest, BelievesOdometryWhereNobodyTellsOfADrift) {
  start();
  mount_laser();
  harness_->publish(topics::kCurrentZone, CurrentZone{.zone_id = 4});
  tell_sweep(SweepPhase::kSweeping, 1.0);
  for (int i = 0; i <= 50; ++i) tell_pose(0.1 * i);
  see(2.0);
  harness_->advance_s(2.0);
  ASSERT_EQ(hits_->size(), 1u);
  EXPECT_EQ(hits_->front().T_zone_base, Pose2{});
}

/// Readers keep a limited queue: a burst of all that waited would push changes out of it.
TEST_F(GridBuilderNodeTest, FusesLinesThatWaitedForTheirPlaceAFewAtATime) {
  start_sweeping();
  see(2.0);
  settle();
  RoomEstimate estimate{.tag = {1, 1, 7}, .found = true};
  estimate.rectangle = {0.0, -0.0075, 0.002, 6.011, 5.018};
  harness_->publish(topics::kRoomEstimate, estimate);
  const Pose2 T_zone_base{0.5, 0.2, 0.3};
  for (int i = 0; i < 50; ++i) tell_pose(5.4 + 0.1 * i, T_zone_base);
  settle();

  const BoxRoom room;
  const std::size_t at_first = changes_->size();
  std::size_t most_at_once = 0;
  int waited = 0;
  constexpr int kLines = 120;
  for (int i = 0; i < kLines; ++i) {
    PointCloud cloud{from_seconds(5.5 + 0.025 * i), "base_link", {}};
    for (const Point3f& p : room.scan(0, {0.5, 0.2, 0.6}, radians(-90.0 + i), 541).hits) {
      const Point2 q = T_zone_base.inverse() * Point2(p.x_m, p.y_m);
      cloud.points.push_back({static_cast<float>(q.x()), static_cast<float>(q.y()), p.z_m});
    }
    const std::size_t before = changes_->size();
    harness_->publish(topics::kPoints, cloud);
    settle();
    most_at_once = std::max(most_at_once, changes_->size() - before);
    waited += changes_->size() == at_first;
  }
  EXPECT_GT(waited, 4);
  EXPECT_LE(most_at_once, 3u);
  harness_->advance_s(1.0);
  EXPECT_EQ(changes_->size(), at_first + kLines);
}

TEST_F(GridBuilderNodeTest, WaitsForTheOdometryThatCoversALine) {
  start_sweeping();
  see(5.05);
  settle();
  EXPECT_EQ(changes_->size(), 1u);
  tell_pose(5.1, {0.1, 0.0, 0.0});
  settle();
  ASSERT_EQ(hits_->size(), 1u);
  EXPECT_NEAR(hits_->front().T_zone_base.x_m, 0.05, 1e-9);
  EXPECT_NEAR(hits_->front().hits[0].x_m, 2.07, 1e-6);
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

TEST_F(GridBuilderNodeTest, GoesOnFromWhereTheRobotStoodWhenTheOdometryBootsAgain) {
  const Pose2 stood{1.5, -0.5, 0.3};
  GridBuilderConfig config;
  config.registration.register_scans = true;
  for (const auto [odometry_comes_first, silence_s] :
       {std::pair{false, 3.0}, std::pair{true, 3.0}, std::pair{true, 0.1}}) {
    start(config);
    mount_laser();
    auto& tf = harness_->collect(topics::kTf);
    tell_zone(1);
    tell_sweep(SweepPhase::kParked, 0.0);
    for (int i = 0; i <= 20; ++i) tell_pose(0.1 * i, interpolate(Pose2{}, stood, 0.05 * i));
    settle();
    harness_->advance_s(silence_s);  // the motors are dead
    if (odometry_comes_first) {
      tell_pose(2.0 + silence_s, {});
      see(2.0 + silence_s);
    }
    settle();
    tell_sweep(SweepPhase::kParked, 0.0, 0.0, 8);
    settle();
    if (!odometry_comes_first) tell_pose(2.0 + silence_s, {});
    tf.clear();
    harness_->advance_s(0.3);
    ASSERT_FALSE(tf.empty());
    const Pose2 off = stood.inverse() * *find_zone_odom(tf.back());
    EXPECT_NEAR(off.translation().norm() + std::abs(off.yaw_rad), 0.0, 1e-9);
  }
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
