// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/floor_plan.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/unit/tools/simulator/test_worlds.hpp"

namespace enfilade::simulator {
namespace {

using test::east_door;
using test::range_along;

constexpr float kNothing = std::numeric_limits<float>::infinity();
const Eigen::Vector3f kEast(1, 0, 0);

TEST(FloorPlan, APassageIsOpenThroughBothRoomsWallsAndClosedAboveItsLintel) {
  FloorPlan plan = test::two_rooms();
  plan.doors.push_back(east_door(1));
  ASSERT_TRUE(problems(plan).empty());
  const RayScene scene(build_world(plan));
  EXPECT_NEAR(range_along(scene, {0, -0.5f, 1.0f}, kEast), 4.0 + test::kWall_m, 1e-4);  // the far wall of b
  EXPECT_NEAR(range_along(scene, {0, -0.5f, 2.1f}, kEast), 2.0, 1e-4);                  // the lintel
  EXPECT_NEAR(range_along(scene, {0, -0.06f, 1.0f}, kEast), 4.0 + test::kWall_m,
              1e-4);                                                     // just inside the jamb
  EXPECT_NEAR(range_along(scene, {0, -0.04f, 1.0f}, kEast), 2.0, 1e-4);  // just beside it
  EXPECT_NEAR(range_along(scene, {3, 0.5f, 1.0f}, -kEast), 3.0 - 2.0 - test::kWall_m,
              1e-4);  // b's side is a wall too
}

TEST(FloorPlan, WallsTwoThicknessesApartAreCutToo) {
  FloorPlan plan = test::two_rooms();
  plan.rooms[1].rectangle.x_m += test::kWall_m;
  plan.doors.push_back(east_door(1));
  ASSERT_TRUE(problems(plan).empty());
  EXPECT_NEAR(range_along(RayScene(build_world(plan)), {0, -0.5f, 1.0f}, kEast), 4.0 + 2 * test::kWall_m,
              1e-4);
}

TEST(FloorPlan, AnExitOpensOnEmptyGround) {
  FloorPlan plan = test::one_room(4.0, 3.0);
  plan.doors.push_back(east_door(std::nullopt));
  const RayScene scene(build_world(plan));
  EXPECT_EQ(range_along(scene, {0, -0.5f, 1.0f}, kEast), kNothing);
  const Eigen::Vector3f down = Eigen::Vector3f(5, 0, -1).normalized();
  EXPECT_NEAR(range_along(scene, {0, -0.5f, 1.0f}, down), std::sqrt(26.0), 1e-3);
}

TEST(FloorPlan, GlassGivesNoEchoAndAnOpenWindowLetsTheBeamOut) {
  for (const bool glass : {true, false}) {
    FloorPlan plan = test::one_room(4.0, 3.0);
    plan.windows.push_back(
        {{.room = 0, .wall = 0, .middle_m = 1.5, .width_m = 1.0, .bottom_m = 0.9, .top_m = 2.0}, glass});
    const RayScene scene(build_world(plan));
    EXPECT_EQ(range_along(scene, {0, 0, 1.5f}, kEast), kNothing);
    EXPECT_NEAR(range_along(scene, {0, 0, 0.8f}, kEast), 2.0, 1e-4);  // below the sill
    const Eigen::Vector3f down = Eigen::Vector3f(4, 0, -1).normalized();
    const float to_ground = range_along(scene, {0, 0, 1.5f}, down);
    EXPECT_EQ(std::isinf(to_ground), glass);
  }
}

TEST(FloorPlan, TruthKnowsRoomsAndDoorsInTheWorldFrame) {
  FloorPlan plan = test::two_rooms();
  plan.doors = {east_door(1)};
  plan.T_world_building = {10.0, 20.0, kPi / 2};
  plan.T_building_start = {1.0, 0.0, 0.0};
  const WorldTruth truth = build_world(plan).truth;
  ASSERT_EQ(truth.rooms.size(), 2u);
  EXPECT_NEAR(truth.rooms[1].rectangle.x_m, 10.0, 1e-9);
  EXPECT_NEAR(truth.rooms[1].rectangle.y_m, 20.0 + 3.0 + test::kWall_m, 1e-9);
  ASSERT_EQ(truth.doors.size(), 1u);
  const Point2 middle = truth.doors[0].opening.midpoint();
  EXPECT_NEAR(middle.x(), 10.0 + 0.5, 1e-9);
  EXPECT_NEAR(middle.y(), 20.0 + 2.0 + 0.5 * test::kWall_m, 1e-9);
  EXPECT_NEAR(truth.doors[0].opening.length(), 0.9, 1e-9);
  EXPECT_EQ(truth.doors[0].room, 0u);
  EXPECT_EQ(truth.doors[0].other, 1u);
  EXPECT_NEAR(truth.T_world_start.y_m, 21.0, 1e-9);
}

TEST(FloorPlan, SaysWhatIsWrongWithAPlan) {
  FloorPlan no_rooms;
  ASSERT_EQ(problems(no_rooms).size(), 1u);

  FloorPlan overlapping = test::two_rooms();
  overlapping.rooms[1].rectangle.x_m -= 0.1;
  ASSERT_EQ(problems(overlapping).size(), 1u);
  EXPECT_EQ(problems(overlapping)[0].line, 2);

  FloorPlan into_room = test::two_rooms();
  into_room.doors = {east_door(std::nullopt)};
  ASSERT_EQ(problems(into_room).size(), 1u);
  EXPECT_EQ(problems(into_room)[0].what, "this door leads into 'b': write to: b");

  FloorPlan apart = test::two_rooms();
  apart.rooms[1].rectangle.x_m += 1.0;
  apart.doors = {east_door(1)};
  EXPECT_EQ(problems(apart).size(), 1u);

  FloorPlan beyond = test::one_room(4.0, 3.0);
  beyond.doors = {east_door(std::nullopt)};
  beyond.doors[0].opening.middle_m = 0.3;
  EXPECT_EQ(problems(beyond).size(), 1u);
}

}  // namespace
}  // namespace enfilade::simulator
