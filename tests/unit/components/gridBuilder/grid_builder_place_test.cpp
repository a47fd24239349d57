// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "tests/unit/components/gridBuilder/box_room.hpp"
#include "tests/unit/components/gridBuilder/grid_builder_node_fixture.hpp"

namespace enfilade::grid_builder {
namespace {

using GridBuilderPlaceTest = GridBuilderNodeTest;

TEST_F(GridBuilderPlaceTest, TellsWhereTheZoneLiesInOdometryWhateverElseHappens) {
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

TEST_F(GridBuilderPlaceTest, LearnsFromTheMapHowFarOdometryHadDriftedBeforeItWasStarted) {
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

TEST_F(GridBuilderPlaceTest, BelievesOdometryWhereNobodyTellsOfADrift) {
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
TEST_F(GridBuilderPlaceTest, FusesLinesThatWaitedForTheirPlaceAFewAtATime) {
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

TEST_F(GridBuilderPlaceTest, WaitsForTheOdometryThatCoversALine) {
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

TEST_F(GridBuilderPlaceTest, GoesOnFromWhereTheRobotStoodWhenTheOdometryBootsAgain) {
  const Pose2 stood{1.5, -0.5, 0.3};
  GridBuilderConfig config;
  config.registration.register_scans = true;
  for (const auto& [odometry_comes_first, silence_s] :
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

}  // namespace
}  // namespace enfilade::grid_builder
