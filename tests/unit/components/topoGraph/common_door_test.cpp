// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/common_door.hpp"

#include <random>

#include <gtest/gtest.h>

#include "tests/unit/components/topoGraph/rooms.hpp"

namespace enfilade::topo_graph {
namespace {

using namespace test;

const PlacedFace kKnown = place(room1(), door_from_room1().gap);

/// Small motions of room 2 about its own centre.
Pose2 drift(std::mt19937& random, double reach_m, double reach_rad) {
  return room2().pose() * random_pose(random, reach_m, reach_rad) * room2().pose().inverse();
}

TEST(CommonDoor, PaperModeMakesTheMidpointsCoincide) {
  const CommonDoorSolver solver({.door_faces = DoorFaces::kPaper});
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const Rectangle seen = drift(random, 0.2, radians(3.0)) * room2();
    const CommonDoor door = solver.solve(kKnown, seen, {door_from_room2()});
    ASSERT_TRUE(door.seen && door.corrected);
    const Rectangle corrected = door.correction * seen;
    EXPECT_LT((place(corrected, door.gap).midpoint() - kKnown.midpoint()).norm(), 1e-12);
    EXPECT_EQ(door.correction.yaw_rad, 0.0);  // eq. 20 tells nothing of the direction
  }
}

TEST(CommonDoor, ThicknessModeKeepsTheMeasuredThicknessAndMakesTheWallsParallel) {
  const CommonDoorSolver solver({});
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    const Rectangle seen = drift(random, 0.05, radians(1.0)) * room2();
    const double measured_m =
        (place(seen, door_from_room2().gap).midpoint() - kKnown.midpoint()).dot(kKnown.normal);
    const CommonDoor door = solver.solve(kKnown, seen, {door_from_room2()});
    const PlacedFace face = place(door.correction * seen, door.gap);
    const Point2 offset = face.midpoint() - kKnown.midpoint();
    EXPECT_NEAR(offset.dot(kKnown.normal), measured_m, 1e-12);
    EXPECT_NEAR(offset.dot(kKnown.segment.direction()), 0.0, 1e-12);
    EXPECT_NEAR(face.normal.dot(kKnown.normal), -1.0, 1e-12);
    EXPECT_NEAR(door.thickness_m, measured_m, 1e-12);
    EXPECT_NEAR(door.measured_thickness_m.value(), measured_m, 1e-12);
  }
}

TEST(CommonDoor, MeetsTheJambThatBothRoomsSawWhereTheOtherOneWasHidden) {
  const CommonDoorSolver solver({});
  std::mt19937 random(3);
  for (const bool first_hidden : {false, true}) {
    DoorEstimate narrow = door_from_room2();
    (first_hidden ? narrow.gap.from_m : narrow.gap.to_m) += first_hidden ? 0.12 : -0.12;
    for (int i = 0; i < 20; ++i) {
      const Pose2 off = drift(random, 0.03, radians(0.5));
      const CommonDoor door = solver.solve(kKnown, off * room2(), {narrow});
      const Rectangle corrected = door.correction * off * room2();
      EXPECT_NEAR(corrected.y_m, room2().y_m, 1e-9);
      EXPECT_NEAR(door.gap.from_m, door_from_room2().gap.from_m, 1e-9) << "the whole door is known";
      EXPECT_NEAR(door.gap.to_m, door_from_room2().gap.to_m, 1e-9);
    }
  }
}

TEST(CommonDoor, ClampsTheThicknessToWhatAWallCanBe) {
  const CommonDoorSolver solver({});
  const CommonDoor overlapping = solver.solve(kKnown, Pose2{-0.5, 0.0, 0.0} * room2(), {door_from_room2()});
  EXPECT_EQ(overlapping.thickness_m, 0.0);
  EXPECT_FALSE(overlapping.measured_thickness_m) << "no wall is so thin: something else is wrong";
  EXPECT_NEAR(overlapping.correction.x_m, 0.5 - kThicknessM, 1e-12);
  const CommonDoor apart = solver.solve(kKnown, Pose2{0.5, 0.0, 0.0} * room2(), {door_from_room2()});
  EXPECT_EQ(apart.thickness_m, 0.4);
  EXPECT_NEAR(apart.correction.x_m, 0.4 - 0.5 - kThicknessM, 1e-12);
}

TEST(CommonDoor, LeavesAWallThatIsFarFromParallelAsItIs) {
  const CommonDoorSolver solver({});
  const Pose2 centre = room2().pose();
  const Rectangle seen = centre * Pose2{0.0, 0.0, radians(12.0)} * centre.inverse() * room2();
  const CommonDoor door = solver.solve(kKnown, seen, {door_from_room2()});
  EXPECT_TRUE(door.corrected);
  EXPECT_EQ(door.correction.yaw_rad, 0.0);
}

TEST(CommonDoor, ProjectsTheKnownDoorWhereTheNewRoomDoesNotShowIt) {
  const CommonDoorSolver solver({});
  DoorEstimate unexplored = door_from_room2();
  unexplored.state = DoorState::kUnexplored;
  const DoorEstimate elsewhere = open_door(1, 1.0, 1.9);
  for (const auto& doors : {std::vector<DoorEstimate>{}, {unexplored}, {elsewhere}}) {
    const CommonDoor door = solver.solve(kKnown, Pose2{0.0, 0.07, 0.0} * room2(), doors);
    EXPECT_FALSE(door.seen);
    EXPECT_TRUE(door.corrected);
    EXPECT_EQ(door.gap.wall, 2);
    EXPECT_NEAR(door.gap.width_m(), 0.9, 1e-12);
    EXPECT_NEAR(door.thickness_m, kThicknessM, 1e-12);
    expect_near(door.correction, {}, 1e-12);  // along the wall nothing is known
  }
}

TEST(CommonDoor, CorrectsNothingFartherThanTheLimit) {
  const CommonDoor door =
      CommonDoorSolver({}).solve(kKnown, Pose2{2.0, 0.0, 0.0} * room2(), {door_from_room2()});
  EXPECT_FALSE(door.corrected);
  EXPECT_EQ(door.correction, Pose2{});
  EXPECT_EQ(door.gap.wall, 2);
}

TEST(CommonDoor, TurnsWithTheWorld) {
  const CommonDoorSolver solver({});
  const Rectangle seen = Pose2{0.03, -0.04, 0.02} * room2();
  const CommonDoor straight = solver.solve(kKnown, seen, {door_from_room2()});
  const Pose2 T{4.0, -7.0, 2.0};
  const PlacedFace known{T * kKnown.segment, rotate(T.yaw_rad, kKnown.normal)};
  const CommonDoor turned = solver.solve(known, T * seen, {door_from_room2()});
  EXPECT_EQ(turned.gap, straight.gap);
  expect_near(turned.correction * T, T * straight.correction, 1e-12);
}

TEST(PlacedFace, IsPushedIntoAWallThatItMissesInPart) {
  const PlacedFace high{{{1.6, 1.5}, {1.6, 2.5}}, {1.0, 0.0}};
  const WallInterval gap = project_on_nearest_wall(high, room2(), radians(30.0));
  EXPECT_EQ(gap.wall, 2);
  EXPECT_NEAR(gap.from_m, 0.0, 1e-12);
  EXPECT_NEAR(gap.to_m, 1.0, 1e-12);
}

}  // namespace
}  // namespace enfilade::topo_graph
