// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "components/topoGraph/core/map_minimiser.hpp"
#include "tests/unit/components/topoGraph/rooms.hpp"
#include "tools/evaluate/graph/room_stream.hpp"

namespace enfilade::topo_graph {
namespace {

using namespace test;
using evaluate::explore;
using evaluate::office_corridor;
using evaluate::ring_of_rooms;

TEST(LoopClosing, TakesNoOfficeForItsIdenticalNeighbour) {
  for (const std::uint64_t seed : {1, 2}) {
    for (const int per_section : {4, 8}) {
      const auto run = explore(office_corridor(8, per_section), {}, {}, seed);
      EXPECT_EQ(run.false_closures, 0);
      EXPECT_EQ(run.missed_rooms, 0);
      EXPECT_EQ(run.duplicates, 0);
    }
  }
}

TEST(LoopClosing, ClosesARing) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const auto run = explore(ring_of_rooms(4, 3), {}, {}, seed);
    EXPECT_EQ(run.state.map.rooms.size(), 10u);
    EXPECT_EQ(run.state.map.doors.size(), 10u);
    EXPECT_EQ(run.missed_rooms, 0);
    EXPECT_LT(run.pose_error_max_m, 0.3);
  }
}

/// Four rooms in a ring whose odometry turns 3° too far in every room, and knows nothing of it.
TEST(LoopClosing, ClosesARingOfBiasedOdometry) {
  evaluate::StreamNoise noise;
  noise.yaw_bias_rad = radians(3.0);
  noise.odometry_yaw_rad = 0.0;
  const auto run = explore(ring_of_rooms(2, 2), noise, {}, 1);
  EXPECT_EQ(run.state.map.rooms.size(), 4u);
  EXPECT_EQ(run.state.map.doors.size(), 4u);
  EXPECT_LT(run.pose_error_max_m, 0.1);
}

/// A ring of 2 x 2 explored, its last loop door made to lie, as if another room's door had been taken for it.
TopoState with_a_false_door() {
  TopoState state = explore(ring_of_rooms(3, 3), {}, {}, 1).state;
  const Room& a = state.map.rooms[1];
  const Room& b = state.map.rooms[4];
  Door door{.id = ++state.session.last_door, .kind = DoorKind::kPassage};
  door.face = {.room = a.id, .gap = {3, 1.0, 1.9}};
  door.other_face = DoorFace{.room = b.id, .gap = {1, 1.0, 1.9}};
  state.map.doors.push_back(door);
  return state;
}

TEST(MapMinimiser, TakesBackADoorThatTheRestContradicts) {
  TopoState state = with_a_false_door();
  const DoorId id = state.map.doors.back().id;
  const TopologicalMap before = state.map;
  const Minimised minimised = MapMinimiser({}, {}).minimise(state, {id});
  EXPECT_EQ(minimised.withdrawn, std::vector<DoorId>{id});
  EXPECT_FALSE(state.map.find_door(id)->other_face);
  EXPECT_EQ(state.map.doors.size(), before.doors.size() + 1);  // two halves
  for (std::size_t i = 0; i < before.rooms.size(); ++i)
    EXPECT_LT((state.map.rooms[i].T_map_room.translation() - before.rooms[i].T_map_room.translation()).norm(),
              0.02);
}

TEST(MapMinimiser, ForgetsNothingThatWasMeasured) {
  TopoState state = explore(ring_of_rooms(2, 2), {}, {}, 1).state;
  const MapMinimiser minimiser({}, {});
  minimiser.minimise(state, {});
  const TopologicalMap once = state.map;
  for (int i = 0; i < 20; ++i) minimiser.minimise(state, {});
  for (std::size_t i = 0; i < once.rooms.size(); ++i) {
    EXPECT_EQ(state.map.rooms[i].measured_size_m, once.rooms[i].measured_size_m);
    EXPECT_NEAR(state.map.rooms[i].width_m, once.rooms[i].width_m, 1e-4);
    expect_near(state.map.rooms[i].T_map_room, once.rooms[i].T_map_room, 1e-3);
  }
}

TEST(Withdrawal, MakesARoomOfALoopThatWasNone) {
  TopoGraph graph = graph_in_zone2({}, {door_from_room1(), second_from_room1()});
  TopoState state = graph.state();
  // Zone 2 was taken for room 1 itself, which it is not.
  LoopClosure closure{.door = 1, .room = 1, .instead = {.width_m = 4.2, .height_m = 3.8}};
  closure.link = {.from = 1, .T_from_to = room2().pose(), .sigma_position_m = 0.1, .sigma_yaw_rad = 0.05};
  closure.entrance = door_from_room2().gap;
  closure.gaps = {{0, 1.0, 2.0}};
  state.session.closures = {closure};
  state.session.zone.room = 1;
  withdraw(state, 1);
  ASSERT_EQ(state.map.rooms.size(), 2u);
  EXPECT_EQ(state.session.zone.room, RoomId{2});
  EXPECT_EQ(state.map.find_door(1)->other_face, (DoorFace{.room = 2, .gap = closure.entrance}));
  EXPECT_EQ(state.map.doors.back().face, (DoorFace{.room = 2, .gap = closure.gaps[0]}));
  EXPECT_TRUE(state.session.closures.empty());
  EXPECT_EQ(state.map.links.back().to, 2u);
}

}  // namespace
}  // namespace enfilade::topo_graph
