// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/localiser.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/topoGraph/rooms.hpp"

namespace enfilade::topo_graph {
namespace {

using namespace test;

/// Rooms 1 and 2 with one door between them.
TopologicalMap two_rooms() {
  TopoGraph graph = graph_in_zone2();
  fix_room2(graph, {});
  return graph.state().map;
}

const Pose2 kAwake{3.0, -7.0, 2.5};  // T_zone_map: nothing is known of it

TEST(Localiser, FindsARoomOfItsOwnSizeAndDoorPattern) {
  Localiser localiser({});
  localiser.take(two_rooms(), seen_from(kAwake, estimate_of(room2(), 1, {door_from_room2()})));
  const auto place = localiser.place();
  ASSERT_TRUE(place);
  EXPECT_EQ(place->room, 2u);
  expect_near(place->T_map_zone, kAwake.inverse(), 1e-9);
}

TEST(Localiser, KnowsNothingOfARoomThatTheMapDoesNotHold) {
  Localiser localiser({});
  localiser.take(two_rooms(), estimate_of({0.0, 0.0, 0.0, 6.0, 2.0}, 1, {}));
  EXPECT_FALSE(localiser.place());
}

TEST(TopoGraph, StartsLostAndFindsItsPlace) {
  TopoGraph before = graph_in_zone2();
  fix_room2(before, {});
  TopoGraph graph({}, lost_state(before.state().map, before.state().session, 99));
  EXPECT_FALSE(graph.state().session.zone.located);
  const RoomEstimate seen = seen_from(kAwake, estimate_of(room2(), 3, {door_from_room2()}));
  EXPECT_FALSE(graph.fix_room({call(50), seen}, 1).reply.accepted);
  const ObserveOutcome outcome = graph.observe(seen);
  ASSERT_TRUE(outcome.correction);
  EXPECT_EQ(outcome.correction->reason, PoseCorrection::Reason::kLocalised);
  EXPECT_TRUE(graph.state().session.zone.located);
  EXPECT_EQ(graph.state().session.zone.room, RoomId{2});
  expect_near(graph.state().session.zone.T_map_zone, kAwake.inverse(), 1e-9);
}

/// Two rooms of one size, each with its door in the middle of the wall between them: alike after a half turn.
TopologicalMap twins() {
  TopologicalMap map;
  map.rooms = {{.id = 1, .width_m = 4.0, .height_m = 3.0},
               {.id = 2, .T_map_room = {4.15, 0.0, 0.0}, .width_m = 4.0, .height_m = 3.0},
               {.id = 3, .T_map_room = {8.3, 0.0, 0.0}, .width_m = 4.0, .height_m = 3.0}};
  const WallInterval east{0, 1.0, 2.0}, west{2, 1.0, 2.0};
  map.doors = {{.id = 1, .kind = DoorKind::kPassage, .face = {1, east}, .other_face = DoorFace{2, west}},
               {.id = 2, .kind = DoorKind::kPassage, .face = {2, east}, .other_face = DoorFace{3, west}}};
  return map;
}

TEST(Localiser, LeavesASymmetricPlaceOpenUntilMotionTells) {
  const TopologicalMap map = twins();
  const auto look = [&](std::size_t room, std::vector<DoorEstimate> doors) {
    return seen_from(kAwake, estimate_of(map.rooms[room].rectangle(), 1, std::move(doors)));
  };
  Localiser localiser({});
  localiser.take(map, look(0, {open_door(0, 1.0, 2.0)}));
  EXPECT_FALSE(localiser.place());  // room 1, or room 3 turned round
  EXPECT_EQ(localiser.hypotheses().size() >= 2, true);
  localiser.take(map, look(1, {open_door(0, 1.0, 2.0), open_door(2, 1.0, 2.0)}));
  EXPECT_FALSE(localiser.place());  // the building looks the same turned by 180°
  TopologicalMap marked = map;      // until a door tells its ends apart
  marked.doors.push_back({.id = 3, .kind = DoorKind::kExit, .face = {3, {1, 0.5, 1.5}}});
  localiser.take(marked, look(2, {open_door(2, 1.0, 2.0), open_door(1, 0.5, 1.5)}));
  const auto place = localiser.place();
  ASSERT_TRUE(place);
  EXPECT_EQ(place->room, 3u);
  expect_near(place->T_map_zone, kAwake.inverse(), 1e-9);
}

}  // namespace
}  // namespace enfilade::topo_graph
