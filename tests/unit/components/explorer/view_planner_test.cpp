// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/view_planner.hpp"

#include <gtest/gtest.h>

#include "components/explorer/core/ray_caster.hpp"
#include "tests/unit/components/explorer/synthetic_room.hpp"

namespace enfilade::explorer {
namespace {

const RoomEstimate kEstimate{.found = true, .rectangle = {0.0, 2.0, 2.0, 4.0, 4.0}};

double worth(const std::vector<ViewTarget>& targets) {
  double sum_m2 = 0.0;
  for (const ViewTarget& t : targets) sum_m2 += t.worth_m2;
  return sum_m2;
}

TEST(RayCaster, FurnitureHidesWhatIsBehindAndBelow) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).solid(2, 1, 2.5, 3, 0.0, 1.0).grid();
  EXPECT_FALSE(is_visible(grid, {1, 2, 0.6}, {4, 2, 0.5}));
  EXPECT_TRUE(is_visible(grid, {1, 2, 0.6}, {4, 2, 1.9}));
  EXPECT_TRUE(is_visible(grid, {1, 2, 0.6}, {0, 2, 0.5}));
}

TEST(ViewTargets, AFullySeenRoomHasNone) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).grid();
  EXPECT_TRUE(ViewTargets({}).find(grid, kEstimate).empty());
}

TEST(ViewTargets, UnseenWallCountsByItsAreaAndMoreWhereADoorMayBe) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).unexplored(3.9, 1, 4.2, 2).grid();
  const double plain_m2 = worth(ViewTargets({}).find(grid, kEstimate));
  EXPECT_NEAR(plain_m2, 1.75, 0.3);
  RoomEstimate with_gap = kEstimate;
  with_gap.doors.push_back({.gap = {.wall = 0, .from_m = 1.0, .to_m = 2.0}, .state = DoorState::kUnexplored});
  EXPECT_NEAR(worth(ViewTargets({}).find(grid, with_gap)), 3.0 * plain_m2, 0.3);
}

TEST(ViewTargets, WhatWasLookedAtInVainCountsLess) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).unexplored(3.9, 1, 4.2, 2).grid();
  ViewTargets targets({});
  const auto before = targets.find(grid, kEstimate);
  for (const ViewTarget& t : before) targets.looked_in_vain(t);
  EXPECT_NEAR(worth(targets.find(grid, kEstimate)), 0.35 * worth(before), 1e-9);
}

struct Planned {
  std::optional<View> view;
  std::vector<ViewTarget> seen;
};

Planned plan(const ProjectedGrid& grid, const Pose2& robot, const ViewWish& wish = {}) {
  const FloorMap map(grid, {}, {});
  const Reach reach(map, {}, robot.translation());
  const ViewPlanner planner({});
  const auto targets = ViewTargets({}).find(grid, kEstimate);
  const auto view = planner.best(grid, reach, kEstimate.rectangle, targets, robot, wish);
  return {view, view ? planner.seen_from(grid, view->pose, targets) : std::vector<ViewTarget>{}};
}

TEST(ViewPlanner, TurnsWhereTheUnseenLiesInTheBlindConeBehind) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).unexplored(-0.1, 1, 0.05, 3).grid();
  const Pose2 robot{2, 2, 0};
  EXPECT_TRUE(ViewPlanner({}).seen_from(grid, robot, ViewTargets({}).find(grid, kEstimate)).empty());
  const Planned planned = plan(grid, robot);
  ASSERT_TRUE(planned.view);
  EXPECT_LT((planned.view->pose.translation() - robot.translation()).norm(), 1e-9);
  EXPECT_FALSE(planned.seen.empty());
}

TEST(ViewPlanner, GoesToWhereItCanSeeBehindFurniture) {
  // A cupboard that is higher than the sensor hides a piece of the right wall.
  const auto grid = SyntheticRoom()
                        .room(0, 0, 4, 4)
                        .solid(2.5, 1.0, 2.7, 3.0, 0.0, 2.2)
                        .unexplored(3.9, 1.2, 4.1, 2.8)
                        .grid();
  const Pose2 robot{1, 2, 0};
  const Planned planned = plan(grid, robot);
  ASSERT_TRUE(planned.view);
  EXPECT_GT((planned.view->pose.translation() - robot.translation()).norm(), 0.5);
  EXPECT_GT(planned.view->gain_m2, 0.5);
}

TEST(ViewPlanner, NothingUnseenIsWorthNoSweep) {
  EXPECT_FALSE(plan(SyntheticRoom().room(0, 0, 4, 4).grid(), {2, 2, 0}).view);
}

TEST(ViewPlanner, AnotherHeadingIsAtLeastAQuarterTurnAway) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).unexplored(3.9, 1, 4.2, 3).grid();
  const Planned planned = plan(grid, {2, 2, 0}, {.other_than_yaw_rad = 0.0});
  ASSERT_TRUE(planned.view);
  EXPECT_GE(std::abs(planned.view->pose.yaw_rad), 0.49 * kPi);
}

TEST(ViewPlanner, DoesNotLookTwiceFromTheSamePose) {
  const auto grid = SyntheticRoom().room(0, 0, 4, 4).unexplored(3.9, 1, 4.2, 3).grid();
  const Planned first = plan(grid, {2, 2, 0});
  ASSERT_TRUE(first.view);
  const Planned second = plan(grid, {2, 2, 0}, {.other_than_yaw_rad = {}, .had = {first.view->pose}});
  ASSERT_TRUE(second.view);
  EXPECT_NE(second.view->pose, first.view->pose);
}

TEST(ViewPlanner, LooksFromElsewhereWhereTheWayIsBarred) {
  const auto grid = SyntheticRoom()
                        .room(0, 0, 4, 4)
                        .solid(2.5, 1.0, 2.7, 3.0, 0.0, 2.2)
                        .unexplored(3.9, 1.2, 4.1, 2.8)
                        .grid();
  const Planned first = plan(grid, {1, 2, 0});
  ASSERT_TRUE(first.view);
  const Point2 barred = first.view->pose.translation();
  const Planned second = plan(grid, {1, 2, 0}, {.other_than_yaw_rad = {}, .had = {}, .barred = {barred}});
  ASSERT_TRUE(second.view);
  EXPECT_GT((second.view->pose.translation() - barred).norm(), 0.4);
}

}  // namespace
}  // namespace enfilade::explorer
