// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/graph_route.hpp"

#include <gtest/gtest.h>

namespace enfilade::explorer {
namespace {

/// Three rooms of 4 × 4 m in a row: 1 at x = 0, 2 at x = 4.2, 3 at x = 8.4; doors 1 and 2 between them, door
/// 3 in the far wall of room 3 and door 4 in the upper wall of room 1.
TopologicalMap three_rooms() {
  TopologicalMap map;
  for (RoomId id = 1; id <= 3; ++id) {
    map.rooms.push_back({.id = id, .T_map_room = {4.2 * (id - 1), 0, 0}, .width_m = 4, .height_m = 4});
  }
  const auto gap = [](std::uint8_t wall) { return WallInterval{wall, 1.5, 2.5}; };
  map.doors = {
      {.id = 1, .kind = DoorKind::kPassage, .face = {1, gap(0)}, .other_face = DoorFace{2, gap(2)}},
      {.id = 2, .kind = DoorKind::kPassage, .face = {2, gap(0)}, .other_face = DoorFace{3, gap(2)}},
      {.id = 3, .kind = DoorKind::kUnresolved, .face = {3, gap(0)}},
      {.id = 4, .kind = DoorKind::kUnresolved, .face = {1, gap(1)}},
  };
  return map;
}

TEST(GraphRoute, TakesTheNearestDoorOfTheRoom) {
  const auto route = find_route(three_rooms(), 1, {0, 0}, {});
  ASSERT_TRUE(route);
  EXPECT_EQ(route->next, 4u);
  EXPECT_EQ(route->target, 4u);
  EXPECT_NEAR(route->length_m, 2.0, 1e-9);
}

TEST(GraphRoute, GoesThroughOtherRoomsToTheLastDoor) {
  auto map = three_rooms();
  map.doors[3].kind = DoorKind::kExit;
  const auto route = find_route(map, 1, {0, 0}, {});
  ASSERT_TRUE(route);
  EXPECT_EQ(route->next, 1u);
  EXPECT_EQ(route->target, 3u);
  EXPECT_NEAR(route->length_m, 10.0, 1e-9);
}

TEST(GraphRoute, UsesNoDoorThatIsClosed) {
  auto map = three_rooms();
  map.doors[3].closed = true;
  EXPECT_EQ(find_route(map, 1, {0, 0}, {})->target, 3u);
  map.doors[0].closed = true;
  EXPECT_FALSE(find_route(map, 1, {0, 0}, {}));
}

TEST(GraphRoute, FindsNothingWhenEveryDoorIsResolvedOrAvoided) {
  auto map = three_rooms();
  EXPECT_FALSE(find_route(map, 1, {0, 0}, {3, 4}));
  EXPECT_FALSE(find_route(map, 1, {0, 0}, {1, 4}));
  map.doors[2].kind = DoorKind::kBlocked;
  map.doors[3].kind = DoorKind::kExit;
  EXPECT_FALSE(find_route(map, 1, {0, 0}, {}));
  EXPECT_FALSE(find_route(map, 9, {0, 0}, {}));
}

}  // namespace
}  // namespace enfilade::explorer
