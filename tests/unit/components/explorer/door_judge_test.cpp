// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/door_judge.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/explorer/synthetic_room.hpp"

namespace enfilade::explorer {
namespace {

/// A room with a door in its right wall, x = 4.0 … 4.2, y = 1.55 … 2.45 less `narrower` on either side.
SyntheticRoom room_with_door(double narrower_m = 0.0) {
  auto room = SyntheticRoom().room(0, 0, 4, 4);
  room.solid(4.0, 0, 4.2, 4);
  return room.free(4.0, 1.55 + narrower_m, 4.2, 2.45 - narrower_m, 0.0, 2.0);
}
SyntheticRoom& add_room_behind(SyntheticRoom& room) {
  return room.free(4.2, 0, 7, 4, 0.0).solid(7, 0, 7.05, 4);
}

const PlacedDoor kDoor{.middle = {4.0, 2.0}, .outward = {1.0, 0.0}, .width_m = 0.9};

DoorJudgement judge(const ProjectedGrid& grid, const PlacedDoor& door) {
  return judge_door(grid, FloorMap(grid, {}, {}), door, nullptr, {});
}

TEST(DoorJudge, ADoorIntoARoomIsAWay) {
  auto room = room_with_door();
  const auto judgement = judge(add_room_behind(room).grid(), kDoor);
  ASSERT_EQ(judgement.verdict, DoorVerdict::kWay);
  EXPECT_NEAR(judgement.corridor->from.y_m, 2.0, 0.03);
  EXPECT_NEAR(judgement.corridor->from.x_m, 3.3, 1e-9);
  EXPECT_NEAR(judgement.corridor->to.x_m, 4.85, 1e-9);
}

TEST(DoorJudge, ADoorOntoEmptyGroundIsAnExit) {
  auto room = room_with_door();
  room.free(4.2, 0, 8, 4, 0.05, 2.6).solid(4.2, 0, 8, 4, 0.0, 0.05);
  EXPECT_EQ(judge(room.grid(), kDoor).verdict, DoorVerdict::kExit);
}

TEST(DoorJudge, ADoorBehindWhichNothingWasSeenIsNoExit) {
  EXPECT_NE(judge(room_with_door().grid(), kDoor).verdict, DoorVerdict::kExit);
}

TEST(DoorJudge, WhatIsTooNarrowOrObstructedIsBlocked) {
  auto narrow = room_with_door(0.25);
  EXPECT_EQ(judge(add_room_behind(narrow).grid(), kDoor).verdict, DoorVerdict::kBlocked);
  auto box = room_with_door();
  add_room_behind(box).solid(4.3, 1.8, 4.6, 2.2, 0.0, 0.4);
  EXPECT_EQ(judge(box.grid(), kDoor).verdict, DoorVerdict::kBlocked);
}

TEST(DoorJudge, TheWayLiesAmidTheJambsAsTheyAreSeen) {
  auto room = room_with_door();
  const PlacedDoor beside{.middle = {4.0, 2.1}, .outward = {1.0, 0.0}, .width_m = 0.9};
  const auto judgement = judge(add_room_behind(room).grid(), beside);
  ASSERT_TRUE(judgement.corridor);
  EXPECT_NEAR(judgement.corridor->to.y_m, 2.0, 0.03);
}

TEST(DoorJudge, TheWayBeginsWhereThereIsRoomToTurnRatherThanFarFromTheDoor) {
  auto room = room_with_door();
  add_room_behind(room).solid(2.9, 1.0, 3.05, 3.0, 0.0, 0.7);
  const auto judgement = judge(room.grid(), kDoor);
  ASSERT_EQ(judgement.verdict, DoorVerdict::kWay);
  EXPECT_NEAR(judgement.corridor->from.x_m, 3.4, 0.03);
}

TEST(DoorJudge, WhereThingsLeaveHalfAMetreTheWayLeadsAmidThem) {
  auto room = room_with_door();
  add_room_behind(room).solid(3.8, 1.0, 3.9, 1.55, 0.0, 0.5).solid(3.8, 2.05, 3.9, 2.5, 0.0, 0.5);
  const auto judgement = judge(room.grid(), kDoor);
  ASSERT_EQ(judgement.verdict, DoorVerdict::kWay);
  EXPECT_GT(judgement.corridor->clearance_m, 0.26);
  EXPECT_NEAR(judgement.corridor->to.y_m, 1.8, 0.01);
}

TEST(DoorJudge, TheNarrowestDoorAskedForIsAWay) {
  auto room = room_with_door(0.075);
  EXPECT_EQ(judge(add_room_behind(room).grid(), kDoor).verdict, DoorVerdict::kWay);
}

}  // namespace
}  // namespace enfilade::explorer
