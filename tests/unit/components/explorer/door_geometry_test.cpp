// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/door_geometry.hpp"

#include <gtest/gtest.h>

namespace enfilade::explorer {
namespace {

/// 4 × 3 m, turned by 30° and away from the origin; a door in wall 1, 0.9 m wide.
const Room kRoom{.id = 1, .T_map_room = {5.0, 2.0, radians(30.0)}, .width_m = 4.0, .height_m = 3.0};
const DoorFace kFace{.room = 1, .gap = {.wall = 1, .from_m = 1.0, .to_m = 1.9}};
const Pose2 kMapZone{1.0, -1.0, radians(12.0)};

TEST(DoorGeometry, StagingLiesInsideAndBeyondLiesOutside) {
  const Pose2 T_zone_room = kMapZone.inverse() * kRoom.T_map_room;
  const PlacedDoor door = place_door(kRoom, kFace, T_zone_room);
  const Point2 inside = T_zone_room.inverse() * door.pose_at(-0.7).translation();
  const Point2 outside = T_zone_room.inverse() * door.pose_at(0.75).translation();
  EXPECT_NEAR(inside.y(), 0.8, 1e-9);
  EXPECT_NEAR(outside.y(), 2.25, 1e-9);
  EXPECT_NEAR(inside.x(), outside.x(), 1e-9);
  EXPECT_NEAR(inside.x(), 2.0 - 1.45, 1e-9);  // wall 1 runs from x = +2 to x = -2
  EXPECT_NEAR(door.width_m, 0.9, 1e-9);
}

TEST(DoorGeometry, QuarterTurnsOfTheEstimateDoNotMoveTheDoor) {
  const Pose2 truth = kMapZone.inverse() * kRoom.T_map_room * Pose2{0.06, -0.04, radians(1.0)};  // drift
  const Point2 expected = place_door(kRoom, kFace, truth).middle;
  for (int k = 0; k < 4; ++k) {
    RoomEstimate estimate{.found = true};
    estimate.rectangle = {wrap_to_pi(truth.yaw_rad + 0.5 * kPi * k), truth.x_m, truth.y_m, k % 2 ? 3.0 : 4.0,
                          k % 2 ? 4.0 : 3.0};
    const Pose2 found = locate_room(kRoom, kMapZone, &estimate, {});
    EXPECT_LT((place_door(kRoom, kFace, found).middle - expected).norm(), 1e-9) << k;
  }
}

TEST(DoorGeometry, RecentEstimateWinsOverTheAccumulatedOne) {
  const Pose2 prior = kMapZone.inverse() * kRoom.T_map_room;
  RoomEstimate estimate{.found = true, .rectangle = {prior.yaw_rad, prior.x_m, prior.y_m, 4.0, 3.0}};
  estimate.recent = Rectangle{prior.yaw_rad, prior.x_m + 0.1, prior.y_m, 4.0, 3.0};
  estimate.recent_stamp_ns = 5;
  EXPECT_NEAR(locate_room(kRoom, kMapZone, &estimate, {}).x_m, prior.x_m + 0.1, 1e-9);
}

TEST(DoorGeometry, AnEstimateOfSomethingElseIsNotBelieved) {
  const Pose2 prior = kMapZone.inverse() * kRoom.T_map_room;
  RoomEstimate other{.found = true, .rectangle = {prior.yaw_rad, prior.x_m, prior.y_m, 6.0, 3.0}};
  EXPECT_EQ(locate_room(kRoom, kMapZone, &other, {}), prior);
  other.rectangle = {prior.yaw_rad, prior.x_m + 1.0, prior.y_m, 4.0, 3.0};
  EXPECT_EQ(locate_room(kRoom, kMapZone, &other, {}), prior);
  EXPECT_EQ(locate_room(kRoom, kMapZone, nullptr, {}), prior);
}

TEST(DoorGeometry, FindsTheGapThatIsTheDoor) {
  const Pose2 T_zone_room = kMapZone.inverse() * kRoom.T_map_room;
  RoomEstimate estimate{.found = true,
                        .rectangle = {T_zone_room.yaw_rad, T_zone_room.x_m, T_zone_room.y_m, 4.0, 3.0}};
  estimate.doors = {{.gap = {.wall = 0, .from_m = 1.0, .to_m = 1.9}},
                    {.gap = {.wall = 1, .from_m = 1.1, .to_m = 2.0}}};
  const PlacedDoor door = place_door(kRoom, kFace, T_zone_room);
  EXPECT_EQ(find_gap(estimate, door, {}), &estimate.doors[1]);
  estimate.doors.pop_back();
  EXPECT_EQ(find_gap(estimate, door, {}), nullptr);
}

TEST(DoorGeometry, TellsOfAnOpenGapWhereTheGraphHasNoDoor) {
  const Pose2 T_zone_room = kMapZone.inverse() * kRoom.T_map_room;
  const TopologicalMap map{.rooms = {kRoom}, .doors = {{.id = 1, .face = kFace}}};
  RoomEstimate estimate{.found = true};
  estimate.rectangle = {T_zone_room.yaw_rad, T_zone_room.x_m, T_zone_room.y_m, kRoom.width_m, kRoom.height_m};
  estimate.doors.push_back({.gap = kFace.gap, .state = DoorState::kOpen});
  EXPECT_FALSE(shows_new_door(estimate, map, kRoom, T_zone_room, {}));
  const int other_wall = (kFace.gap.wall + 1) % 4;
  estimate.doors.push_back(
      {.gap = {.wall = other_wall, .from_m = 1.0, .to_m = 1.9}, .state = DoorState::kPossible});
  EXPECT_FALSE(shows_new_door(estimate, map, kRoom, T_zone_room, {}));
  estimate.doors.back().state = DoorState::kOpen;
  EXPECT_TRUE(shows_new_door(estimate, map, kRoom, T_zone_room, {}));
  estimate.rectangle.width_m += 1.0;  // another room
  EXPECT_FALSE(shows_new_door(estimate, map, kRoom, T_zone_room, {}));
}

}  // namespace
}  // namespace enfilade::explorer
