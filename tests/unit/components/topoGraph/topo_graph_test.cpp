// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/topo_graph.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/topoGraph/rooms.hpp"

namespace enfilade::topo_graph {
namespace {

using namespace test;

TEST(TopoGraph, FixesTheFirstRoomWhereItIs) {
  TopoGraph graph = new_graph();
  const auto outcome = graph.fix_room({call(1), estimate_of(room1(), 1, {door_from_room1()})}, 7);
  ASSERT_TRUE(outcome.reply.accepted && outcome.fixed);
  EXPECT_EQ(outcome.reply.room, 1u);
  EXPECT_FALSE(outcome.correction);
  const TopologicalMap& map = graph.state().map;
  EXPECT_EQ(map.version, 1u);
  EXPECT_EQ(map.rooms.at(0).rectangle(), room1());
  EXPECT_EQ(map.doors.at(0).kind, DoorKind::kUnresolved);
  EXPECT_EQ(map.doors.at(0).face, (DoorFace{1, door_from_room1().gap}));
  EXPECT_EQ(graph.state().session.zone.room, RoomId{1});
}

TEST(TopoGraph, MakesDoorsOfOpenGapsOnly) {
  TopoGraph graph = new_graph();
  RoomEstimate estimate =
      estimate_of(room1(), 1, {open_door(0, 1, 2), open_door(1, 1, 2), open_door(2, 1, 2)});
  estimate.doors[0].state = DoorState::kPossible;
  estimate.doors[1].state = DoorState::kUnexplored;
  graph.fix_room({call(1), estimate}, 7);
  ASSERT_EQ(graph.state().map.doors.size(), 1u);
  EXPECT_EQ(graph.state().map.doors[0].face.gap.wall, 2);
}

// A room is the same room, wall by wall, however the estimate named the sides and wherever it is.
TEST(TopoGraph, NamesWallsByTheMapFrame) {
  for (int quarter = 0; quarter < 4; ++quarter) {
    TopoGraph graph = new_graph();
    Rectangle renamed_room = room1();
    renamed_room.yaw_rad = wrap_to_pi(0.5 * kPi * quarter + 0.2);
    if (quarter % 2 != 0) std::swap(renamed_room.width_m, renamed_room.height_m);
    const DoorEstimate door = open_door((4 - quarter) % 4, 2.0, 2.9);
    graph.fix_room({call(1), estimate_of(renamed_room, 1, {door})}, 7);
    const Room& room = graph.state().map.rooms.at(0);
    EXPECT_NEAR(room.T_map_room.yaw_rad, 0.2, 1e-12);
    EXPECT_EQ(room.width_m, 3.2);
    EXPECT_EQ(graph.state().map.doors.at(0).face, (DoorFace{1, {0, 2.0, 2.9}}));
    const Segment expected = segment_of(renamed_room, door.gap);
    EXPECT_LT((segment_in_map(room, graph.state().map.doors[0].face).midpoint() - expected.midpoint()).norm(),
              1e-12);
  }
}

TEST(TopoGraph, CorrectsTheSecondRoomAndTheRobotTogether) {
  TopoGraph graph = graph_in_zone2();
  const Pose2 T_zone_true = room2().pose() * Pose2{0.0, 0.08, radians(2.0)} * room2().pose().inverse();
  const auto outcome = fix_room2(graph, T_zone_true);
  ASSERT_TRUE(outcome.correction);
  EXPECT_EQ(outcome.correction->reason, PoseCorrection::Reason::kCommonDoor);
  EXPECT_EQ(outcome.correction->room, 2u);
  const Room& room = graph.state().map.rooms.at(1);
  EXPECT_NEAR(room.T_map_room.yaw_rad, 0.0, 1e-12);
  EXPECT_NEAR(room.T_map_room.y_m, 0.0, 1e-12);
  const Pose2& T_map_zone = graph.state().session.zone.T_map_zone;
  EXPECT_EQ(T_map_zone, outcome.correction->T_map_odom);
  expect_near(T_map_zone * T_zone_true * room2().pose(), room.T_map_room, 1e-12);
}

TEST(TopoGraph, JoinsTwoRoomsByTheDoorBetweenThem) {
  TopoGraph graph = graph_in_zone2();
  const auto outcome = fix_room2(graph, {0.02, 0.05, 0.0}, {door_from_room2(), open_door(0, 1.0, 2.0)});
  EXPECT_EQ(outcome.joined_doors, std::vector<DoorId>{1});
  EXPECT_EQ(outcome.new_doors, std::vector<DoorId>{2});
  const Door& door = graph.state().map.doors.at(0);
  EXPECT_EQ(door.kind, DoorKind::kPassage);
  EXPECT_EQ(door.face.room, 1u);
  EXPECT_EQ(door.other_face, (DoorFace{2, door_from_room2().gap}));
}

TEST(TopoGraph, JoinsASecondDoorBetweenTheTwoRooms) {
  TopoGraph graph = graph_in_zone2({}, {second_from_room1(), door_from_room1()});
  // Zone 2 was entered through door 1, the lower one.
  const auto outcome = fix_room2(graph, {0.02, 0.05, 0.0}, {door_from_room2(), second_from_room2()});
  EXPECT_EQ(outcome.joined_doors, (std::vector<DoorId>{1, 2}));
  EXPECT_TRUE(outcome.new_doors.empty());
  for (const Door& door : graph.state().map.doors) EXPECT_EQ(door.kind, DoorKind::kPassage);
}

TEST(TopoGraph, DoesNotJoinDoorsThatDoNotFaceEachOther) {
  TopoGraph graph = graph_in_zone2({}, {second_from_room1(), door_from_room1()});
  const auto outcome =
      fix_room2(graph, {}, {second_from_room2(), open_door(2, 0.2, 0.8), open_door(3, 0.0, 0.8)});
  EXPECT_EQ(outcome.joined_doors, std::vector<DoorId>{1});
  EXPECT_EQ(outcome.new_doors.size(), 2u);
}

TEST(TopoGraph, AnswersARepeatedCallTheSameAndDoesItOnce) {
  TopoGraph graph = graph_in_zone2();
  const FixRoomOutcome first = fix_room2(graph, {0.02, 0.05, 0.0});
  const TopoState after = graph.state();
  EXPECT_EQ(fix_room2(graph, {0.5, 0.5, 0.5}).reply, first.reply);  // the id counts, not the content
  const auto enter = graph.enter_zone({call(2), 1, 1, {}, 99}, 99);
  EXPECT_TRUE(enter.reply.accepted);
  EXPECT_EQ(enter.reply.zone_id, 2u);
  EXPECT_EQ(graph.state(), after);
  const MarkDoorOutcome refusal = graph.mark_door({call(4), 77, DoorKind::kExit}, 1);
  EXPECT_FALSE(refusal.reply.accepted);
  EXPECT_EQ(graph.mark_door({call(4), 1, DoorKind::kBlocked}, 1).reply, refusal.reply);
}

TEST(TopoGraph, ForgetsOnlyTheOldestAnswers) {
  GraphConfig config;
  config.remembered_answers = 2;
  TopoGraph graph = new_graph(config);
  for (std::uint64_t i = 1; i <= 5; ++i) graph.mark_door({call(i), 9, DoorKind::kExit}, 1);
  ASSERT_EQ(graph.state().session.answers.size(), 2u);
  EXPECT_EQ(graph.state().session.answers[0].call, call(4));
}

TEST(TopoGraph, AnswersTheSameRoomWhenAZoneIsFixedAgain) {
  TopoGraph graph = graph_in_zone2();
  const auto old_zone = graph.fix_room({call(10), estimate_of(room1(), 1, {})}, 1);
  EXPECT_EQ(old_zone.reply.room, 1u);
  fix_room2(graph, {});
  const TopologicalMap before = graph.state().map;
  const auto again = graph.fix_room({call(11), estimate_of(room2(), 2, {})}, 1);
  EXPECT_TRUE(again.reply.accepted);
  EXPECT_EQ(again.reply.room, 2u);
  EXPECT_EQ(graph.state().map, before);
}

TEST(TopoGraph, ARoomSeenAgainGetsTheDoorThatWasMissedAndKeepsTheRest) {
  TopoGraph graph = graph_in_zone2();
  fix_room2(graph, {});
  const TopologicalMap before = graph.state().map;
  const auto again = graph.fix_room({call(11), estimate_of(room2(), 2, {open_door(0, 1, 2)})}, 1);
  EXPECT_EQ(again.reply.room, 2u);
  EXPECT_TRUE(again.revisited);
  ASSERT_EQ(again.new_doors.size(), 1u);
  EXPECT_EQ(graph.state().map.doors.size(), before.doors.size() + 1);
  EXPECT_EQ(graph.state().map.rooms, before.rooms);
  const auto third = graph.fix_room({call(12), estimate_of(room2(), 2, {open_door(0, 1, 2)})}, 1);
  EXPECT_TRUE(third.new_doors.empty());
  const auto other = graph.fix_room({call(13), estimate_of(room1(), 2, {open_door(0, 1, 2)})}, 1);
  EXPECT_TRUE(other.new_doors.empty());  // not this room
}

TEST(TopoGraph, RefusesWhatCannotBe) {
  TopoGraph graph = new_graph();
  RoomEstimate nothing = estimate_of(room1(), 1, {});
  nothing.found = false;
  EXPECT_FALSE(graph.fix_room({call(1), nothing}, 1).reply.accepted);
  EXPECT_FALSE(graph.fix_room({call(2), estimate_of(room1(), 5, {})}, 1).reply.accepted);
  EXPECT_FALSE(graph.enter_zone({call(3), 1, 1, {}, 1}, 1).reply.accepted);
  graph.fix_room({call(4), estimate_of(room1(), 1, {door_from_room1()})}, 1);
  EXPECT_FALSE(graph.enter_zone({call(5), 2, 1, {}, 1}, 1).reply.accepted);
  EXPECT_FALSE(graph.mark_door({call(6), 1, DoorKind::kPassage}, 1).reply.accepted);
  EXPECT_EQ(graph.state().map.version, 1u);
}

TEST(TopoGraph, CountsZonesAndCarriesTheCorrectionOn) {
  TopoGraph graph = graph_in_zone2();
  EXPECT_EQ(graph.state().session.zone,
            (CurrentZone{.zone_id = 2, .from_room = 1, .via_door = 1, .valid_from_ns = from_seconds(15.0)}));
  fix_room2(graph, {0.02, 0.05, 0.0});
  const Pose2 T_map_zone = graph.state().session.zone.T_map_zone;
  const auto back = graph.enter_zone({call(9), 2, 1, {1.0, 0.5, 0.0}, 42}, 43);
  EXPECT_EQ(back.reply.zone_id, 3u);
  EXPECT_EQ(graph.state().session.zone.room, RoomId{1});  // the door's other face tells
  EXPECT_EQ(graph.state().session.zone.T_map_zone, T_map_zone);
}

TEST(TopoGraph, ComparesAKnownRoomEnteredAgainWithTheWholeEstimate) {
  TopoGraph graph = graph_in_zone2();
  fix_room2(graph, {});
  graph.enter_zone({call(9), 2, 1, {1.0, 0.5, 0.0}, 42}, 43);
  const Pose2 T_zone_true{0.1, -0.05, 0.03};
  ASSERT_TRUE(graph.observe(seen_from(T_zone_true, estimate_of(room1(), 3, {}))).correction);
  expect_near(graph.state().session.zone.T_map_zone * T_zone_true, {}, 1e-9);
}

TEST(TopoGraph, KnowsARoomByItsPlaceAndMergesItsDoor) {
  TopoGraph graph = graph_in_zone2({}, {door_from_room1(), second_from_room1()});
  // Door 2 of room 1 was not matched: room 2 saw its own side a little too far off, as door 3.
  GraphConfig strict;
  TopoState state = graph.state();
  strict.fixer.face_match.max_distance_m = 0.05;
  TopoGraph apart(strict, state);
  fix_room2(apart, {}, {door_from_room2(), second_from_room2()});
  ASSERT_EQ(apart.state().map.doors.size(), 3u);

  TopoGraph merging({}, apart.state());
  const auto outcome = merging.enter_zone({call(9), 2, 3, {1.0, -1.0, 0.0}, 42}, 43);
  EXPECT_TRUE(outcome.joined_by_position);
  EXPECT_EQ(merging.state().session.zone.room, RoomId{1});
  ASSERT_EQ(merging.state().map.doors.size(), 2u);
  const Door& door = merging.state().map.doors[1];
  EXPECT_EQ(door.id, 3u);
  EXPECT_EQ(door.kind, DoorKind::kPassage);
  EXPECT_EQ(door.other_face, (DoorFace{1, second_from_room1().gap}));
}

TEST(TopoGraph, TakesARectangleThatCoversAStoredRoomForThatRoom) {
  TopoGraph graph = graph_in_zone2();
  RoomEstimate estimate = estimate_of(room2(), 2, {door_from_room2()});
  fix_room2(graph, {});
  // Out through a new door of room 2, and round into room 2 again without knowing it.
  TopoState state = graph.state();
  state.session.zone = {.zone_id = 3};
  state.session.reference.reset();
  TopoGraph lost({}, state);
  const Rectangle nearly = Pose2{0.1, 0.05, 0.0} * room2();
  const auto outcome =
      lost.fix_room({call(20), estimate_of(nearly, 3, {door_from_room2(), open_door(1, 1.0, 2.0)})}, 1);
  EXPECT_TRUE(outcome.covered);
  EXPECT_EQ(outcome.reply.room, 2u);
  EXPECT_EQ(lost.state().map.rooms.size(), 2u);
  EXPECT_EQ(outcome.new_doors.size(), 1u);
  EXPECT_EQ(lost.state().map.doors.back().face.gap.wall, 1);
  EXPECT_NEAR(lost.state().map.doors.back().face.gap.middle_m(), 1.5, 1e-9);
  expect_near(lost.state().session.zone.T_map_zone * nearly.pose(), room2().pose(), 1e-9);
}

TEST(TopoGraph, MarksExitsAndBlockedDoors) {
  TopoGraph graph = graph_in_zone2({}, {door_from_room1(), second_from_room1()});
  EXPECT_TRUE(graph.mark_door({call(8), 2, DoorKind::kExit}, 1).marked);
  EXPECT_EQ(graph.state().map.find_door(2)->kind, DoorKind::kExit);
  fix_room2(graph, {});
  EXPECT_FALSE(graph.mark_door({call(9), 1, DoorKind::kExit}, 1).reply.accepted);
  EXPECT_TRUE(graph.mark_door({call(10), 1, DoorKind::kBlocked}, 1).reply.accepted);
}

TEST(TopoGraph, ClosesAndOpensDoorsAndLeavesThemWhatTheyAre) {
  TopoGraph graph = graph_in_zone2();
  fix_room2(graph, {});
  const auto mark = [&graph](std::uint64_t number, std::optional<bool> closed) {
    return graph.mark_door({call(number), 1, DoorKind::kUnresolved, closed}, 1);
  };
  const Door before = *graph.state().map.find_door(1);
  const std::uint64_t version = graph.state().map.version;
  EXPECT_TRUE(mark(8, true).marked);
  EXPECT_TRUE(graph.state().map.find_door(1)->closed);
  EXPECT_EQ(graph.state().map.find_door(1)->kind, DoorKind::kPassage);
  EXPECT_EQ(graph.state().map.version, version + 1);
  EXPECT_FALSE(mark(9, true).marked);  // it is closed already
  EXPECT_TRUE(mark(10, false).marked);
  EXPECT_EQ(*graph.state().map.find_door(1), before);
  EXPECT_FALSE(mark(11, std::nullopt).reply.accepted);
}

}  // namespace
}  // namespace enfilade::topo_graph
