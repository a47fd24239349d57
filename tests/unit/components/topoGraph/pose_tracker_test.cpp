// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/pose_tracker.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/unit/components/topoGraph/rooms.hpp"

namespace enfilade::topo_graph {
namespace {

using test::expect_near;
using test::random_pose;

/// The same points, the sides named `quarters` quarter turns further on.
Rectangle renamed_sides(const Rectangle& r, int quarters) {
  Rectangle out = r;
  out.yaw_rad = wrap_to_pi(r.yaw_rad + 0.5 * kPi * quarters);
  if (quarters % 2 != 0) std::swap(out.width_m, out.height_m);
  return out;
}

TEST(ModelDeviation, MapsTheOldRoomFrameToTheNew) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const Pose2 before = random_pose(random, 20.0, kPi), after = random_pose(random, 20.0, kPi);
    expect_near(model_deviation(before, after) * before, after, 1e-12);
  }
}

TEST(PoseTracker, RecoversAnyPoseChangeWhateverTheSidesAreCalled) {
  const PoseTracker tracker({});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> side(2.0, 8.0);
  for (int i = 0; i < 400; ++i) {
    const Pose2 pose = random_pose(random, 10.0, kPi);
    const double width_m = side(random);
    const double height_m = i % 2 == 0 ? width_m + 0.01 : side(random);  // near-squares too
    const Rectangle reference{pose.yaw_rad, pose.x_m, pose.y_m, width_m, height_m};
    const Pose2 T_new_old =
        reference.pose() * random_pose(random, 0.3, radians(14.0)) * reference.pose().inverse();
    const auto D = tracker.deviation(reference, renamed_sides(T_new_old * reference, i % 4));
    ASSERT_TRUE(D);
    expect_near(*D, T_new_old, 1e-9);
  }
}

TEST(PoseTracker, RefusesAnotherSizeAndTooLargeMotions) {
  const PoseTracker tracker({});
  const Rectangle reference{0.1, 1.0, 2.0, 3.2, 4.8};
  const auto shifted = [&](double x_m, double yaw_rad) {
    Rectangle r = reference;
    r.x_m += x_m;
    r.yaw_rad += yaw_rad;
    return r;
  };
  EXPECT_TRUE(tracker.deviation(reference, shifted(0.49, 0.0)));
  EXPECT_FALSE(tracker.deviation(reference, shifted(0.51, 0.0)));
  EXPECT_TRUE(tracker.deviation(reference, shifted(0.0, radians(14.9))));
  EXPECT_FALSE(tracker.deviation(reference, shifted(0.0, radians(15.1))));
  Rectangle longer = reference;
  longer.width_m += 0.16;
  EXPECT_FALSE(tracker.deviation(reference, longer));
}

TEST(PoseTracker, TakesTinyDeviationsForNoise) {
  const PoseTracker tracker({});
  const Rectangle reference{0.0, 30.0, 0.0, 3.0, 4.0};
  EXPECT_FALSE(tracker.is_significant(reference, {0.0005, 0.0, 0.0}));
  EXPECT_TRUE(tracker.is_significant(reference, {0.002, 0.0, 0.0}));
  EXPECT_TRUE(tracker.is_significant(reference, {0.0, 0.0, radians(0.03)}));
}

TEST(PoseTracker, RejectsLimitsThatMakeNoSense) {
  EXPECT_THROW(PoseTracker({.max_turn_rad = radians(50.0)}), std::invalid_argument);
}

// The whole loop: the odometry slips by S, so that what stood at p in the zone frame is now seen at S·p. The
// correction must leave the room, and with it the robot, where it was in the map.
TEST(TopoGraph, ReturnsTheRobotToItsTruePoseByModelDeviation) {
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    TopoGraph graph = test::new_graph();
    RoomEstimate estimate = test::estimate_of(test::room1(), 1, {});
    estimate.recent = estimate.rectangle;
    estimate.recent_stamp_ns = estimate.stamp_ns;
    graph.fix_room({test::call(1), estimate}, 1);
    Pose2 S;  // accumulated: several slips, each compared with the one reference
    const Pose2 T_map_base = random_pose(random, 1.0, kPi);
    for (int slip = 1; slip <= 3; ++slip) {
      S = random_pose(random, 0.1, radians(4.0)) * S;
      RoomEstimate later = test::seen_from(S, estimate);
      later.recent_stamp_ns += from_seconds(slip);
      ASSERT_TRUE(graph.observe(later).correction);
      const Pose2 T_zone_base = S * T_map_base;
      expect_near(graph.state().session.zone.T_map_zone * T_zone_base, T_map_base, 1e-9);
      EXPECT_FALSE(graph.observe(later).correction) << "the same deviation twice";
    }
  }
}

TEST(TopoGraph, DoesNotTakeTheBiasOfRecentModelsForMotion) {
  TopoGraph graph = test::new_graph();
  RoomEstimate estimate = test::estimate_of(test::room1(), 1, {});
  estimate.recent = Pose2{0.05, -0.03, 0.01} * estimate.rectangle;
  estimate.recent_stamp_ns = 5;
  graph.fix_room({test::call(1), estimate}, 1);
  estimate.recent_stamp_ns = 6;
  EXPECT_FALSE(graph.observe(estimate).correction);
  EXPECT_EQ(graph.state().session.zone.T_map_zone, Pose2{});
}

TEST(TopoGraph, LeavesThePoseAloneWhileTheRoomIsBeingModelled) {
  TopoGraph graph = test::new_graph();
  RoomEstimate estimate = test::estimate_of(test::room1(), 1, {});
  estimate.recent = Pose2{0.1, 0.0, 0.0} * estimate.rectangle;
  estimate.recent_stamp_ns = 5;
  EXPECT_FALSE(graph.observe(estimate).correction);
}

TEST(TopoGraph, IgnoresEstimatesOfAnotherZoneOrOlderThanTheReference) {
  TopoGraph graph = test::new_graph();
  RoomEstimate estimate = test::estimate_of(test::room1(), 1, {});
  estimate.recent = estimate.rectangle;
  estimate.recent_stamp_ns = 10;
  graph.fix_room({test::call(1), estimate}, 1);
  estimate.recent = Pose2{0.1, 0.0, 0.0} * estimate.rectangle;
  estimate.recent_stamp_ns = 9;
  EXPECT_FALSE(graph.observe(estimate).correction);
  estimate.recent_stamp_ns = 11;
  estimate.tag.zone_id = 2;
  EXPECT_FALSE(graph.observe(estimate).correction);
  estimate.tag.zone_id = 1;
  EXPECT_TRUE(graph.observe(estimate).correction);
}

TEST(TopoGraph, FindsTheRoomAgainAfterTheOdometryRestarted) {
  TopoGraph graph = test::new_graph();
  RoomEstimate estimate = test::estimate_of(test::room1(), 1, {test::door_from_room1()});
  graph.fix_room({test::call(1), estimate}, 1);
  for (const double yaw_deg : {30.0, 100.0, 170.0}) {  // the door tells which way round the room is
    const Pose2 T_zone_true{1.0, -0.4, radians(yaw_deg)};
    RoomEstimate later = test::seen_from(T_zone_true, estimate);
    later.tag.odom_boot = graph.state().session.odom_boot.value() + 1;
    const ObserveOutcome outcome = graph.observe(later);
    EXPECT_TRUE(outcome.odometry_restarted);
    ASSERT_TRUE(outcome.room_found_again);
    expect_near(graph.state().session.zone.T_map_zone * T_zone_true, Pose2{}, 1e-9);
    EXPECT_FALSE(graph.observe(later).odometry_restarted);
  }
}

}  // namespace
}  // namespace enfilade::topo_graph
