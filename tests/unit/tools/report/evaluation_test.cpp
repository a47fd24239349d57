// SPDX-License-Identifier: Apache-2.0
#include "tools/report/evaluation.hpp"

#include <gtest/gtest.h>

namespace enfilade::report {
namespace {

using simulator::WorldTruth;

/// Two rooms of 4 × 3 m and 3 × 3 m side by side, walls 0.2 m thick, a 0.9 m passage between them and an exit
/// to the west; the robot starts in the middle of the first room, turned by 0.4 rad.
WorldTruth two_rooms() {
  WorldTruth truth;
  truth.T_world_start = {5.0, 2.0, 0.4};
  truth.rooms = {{"a", {.yaw_rad = 0.0, .x_m = 5.0, .y_m = 2.0, .width_m = 4.0, .height_m = 3.0}},
                 {"b", {.yaw_rad = 0.0, .x_m = 8.7, .y_m = 2.0, .width_m = 3.0, .height_m = 3.0}}};
  truth.doors = {{.name = "passage", .opening = {{7.1, 2.05}, {7.1, 2.95}}, .room = 0, .other = 1},
                 {.name = "exit", .opening = {{2.9, 2.5}, {2.9, 1.5}}, .room = 0}};
  return truth;
}

/// The map that a flawless robot would make of it, in its own frame.
TopologicalMap flawless_map(const WorldTruth& truth) {
  const Pose2 T_map_world = truth.T_world_start.inverse();
  TopologicalMap map;
  for (std::size_t i = 0; i < truth.rooms.size(); ++i) {
    const Rectangle r = T_map_world * truth.rooms[i].rectangle;
    map.rooms.push_back({.id = static_cast<RoomId>(i + 1),
                         .T_map_room = r.pose(),
                         .width_m = r.width_m,
                         .height_m = r.height_m});
  }
  map.doors.push_back({.id = 1,
                       .kind = DoorKind::kPassage,
                       .face = {1, {0, 1.55, 2.45}},
                       .other_face = DoorFace{2, {2, 0.55, 1.45}}});
  map.doors.push_back({.id = 2, .kind = DoorKind::kExit, .face = {1, {2, 1.0, 2.0}}});
  return map;
}

TEST(Evaluation, FlawlessMapHasNoErrorWhereverTheRobotStarted) {
  const WorldTruth truth = two_rooms();
  const Evaluation e = evaluate(flawless_map(truth), truth);
  EXPECT_NEAR(e.metrics.room_iou_mean.value(), 1.0, 1e-9);
  EXPECT_NEAR(e.metrics.size_error_max_m.value(), 0.0, 1e-9);
  EXPECT_NEAR(e.metrics.door_error_mean_m.value(), 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(e.metrics.room_recall.value(), 1.0);
  EXPECT_DOUBLE_EQ(e.metrics.door_precision.value(), 1.0);
  EXPECT_NEAR(e.rooms[0].measured.yaw_rad, 0.0, 1e-9);
  EXPECT_EQ(e.rooms[0].doors, (std::vector<DoorId>{1, 2}));
}

TEST(Evaluation, SizeErrorIsMeasuredOnTheSideItBelongsTo) {
  const WorldTruth truth = two_rooms();
  TopologicalMap map = flawless_map(truth);
  map.rooms[0].T_map_room.yaw_rad += kPi / 2;  // the same room with its sides named the other way
  std::swap(map.rooms[0].width_m, map.rooms[0].height_m);
  map.rooms[0].height_m += 0.1;  // along the world's x
  const Evaluation e = evaluate(map, truth);
  EXPECT_NEAR(e.rooms[0].measured.width_m - e.rooms[0].truth->width_m, 0.1, 1e-9);
  EXPECT_NEAR(e.metrics.size_error_max_m.value(), 0.1, 1e-9);
  EXPECT_NEAR(e.metrics.size_error_mean_m.value(), 0.025, 1e-9);
}

TEST(Evaluation, RoomThatIsNotThereCostsPrecisionAndMissedDoorCostsRecall) {
  const WorldTruth truth = two_rooms();
  TopologicalMap map = flawless_map(truth);
  map.rooms.push_back({.id = 3, .T_map_room = {30.0, 0.0, 0.0}, .width_m = 3.0, .height_m = 3.0});
  map.doors.pop_back();
  const Metrics m = evaluate(map, truth).metrics;
  EXPECT_NEAR(m.room_precision.value(), 2.0 / 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(m.room_recall.value(), 1.0);
  EXPECT_DOUBLE_EQ(m.door_recall.value(), 0.5);
  EXPECT_DOUBLE_EQ(m.door_precision.value(), 1.0);
}

TEST(Evaluation, DoorInAnotherPartOfTheWallIsNoMatch) {
  const WorldTruth truth = two_rooms();
  TopologicalMap map = flawless_map(truth);
  map.doors[0].face.gap = {0, 0.2, 1.1};
  map.doors[0].other_face = DoorFace{2, {2, 1.9, 2.8}};
  const Evaluation e = evaluate(map, truth);
  EXPECT_FALSE(e.doors[0].truth.has_value());
  EXPECT_DOUBLE_EQ(e.metrics.door_recall.value(), 0.5);
}

TEST(Evaluation, WorldWithoutTruthLeavesRatesUndefined) {
  const Metrics m = evaluate(flawless_map(two_rooms()), WorldTruth{}).metrics;
  EXPECT_FALSE(m.room_precision.has_value());
  EXPECT_FALSE(m.doors_true.has_value());
  EXPECT_EQ(m.rooms_found, 2);
}

}  // namespace
}  // namespace enfilade::report
