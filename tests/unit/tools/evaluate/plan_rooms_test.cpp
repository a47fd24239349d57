// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/maps/plan_rooms.hpp"

#include <array>

#include <gtest/gtest.h>

namespace enfilade::evaluate {
namespace {

/// A black image of 200 × 120 pixels with white boxes, rows counted from the top.
simulator::GreyImage plan_of(std::initializer_list<std::array<int, 4>> boxes) {
  simulator::GreyImage image{200, 120, std::vector<std::uint8_t>(200 * 120, 0)};
  for (const auto& [x0, y0, x1, y1] : boxes)
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x) image.pixels[static_cast<std::size_t>(200 * y + x)] = 255;
  return image;
}

TEST(PlanRooms, AreTheWhiteAreasInMetresFromTheLowerLeftCorner) {
  const auto truth = plan_of({{20, 20, 100, 80}, {110, 20, 190, 60}, {20, 100, 30, 110}});
  const auto rooms = plan_rooms(truth, truth, 0.05);
  ASSERT_EQ(rooms.size(), 2u) << "a quarter of a square metre is no room";
  EXPECT_NEAR(rooms[0].rectangle.x_m, 3.0, 1e-9);
  EXPECT_NEAR(rooms[0].rectangle.y_m, 3.5, 1e-9);
  EXPECT_NEAR(rooms[0].rectangle.area_m2(), 12.0, 1e-9);
  EXPECT_NEAR(rooms[0].fill, 1.0, 1e-9);
}

TEST(PlanRooms, ARoomWithAnAlcoveFillsLessOfItsRectangle) {
  const auto truth = plan_of({{20, 20, 100, 80}, {100, 20, 140, 50}});
  EXPECT_NEAR(plan_rooms(truth, truth, 0.05).at(0).fill, 0.83, 0.01);
}

TEST(PlanRooms, ADoorwayIsNoPartOfTheRectangle) {
  const auto truth = plan_of({{20, 20, 100, 80}, {50, 80, 68, 86}});
  const PlanRoom room = plan_rooms(truth, truth, 0.05).at(0);
  EXPECT_NEAR(room.rectangle.area_m2(), 12.0, 0.01);
  EXPECT_NEAR(room.fill, 12.0 / 12.27, 0.01);
}

TEST(PlanRooms, TheRobotStandsApartFromFurniture) {
  const auto truth = plan_of({{20, 20, 100, 80}});
  const auto furnished = plan_of({{20, 20, 60, 80}, {90, 20, 100, 80}});
  const auto stands = plan_rooms(truth, furnished, 0.05).at(0).stands;
  ASSERT_EQ(stands.size(), 3u);
  EXPECT_NEAR(stands[0].x(), 2.0, 0.03) << "the middle of the free part";
  for (const Point2& stand : stands) EXPECT_LT(stand.x(), 3.0 - 0.25);
}

TEST(PlanRooms, TheRobotDoesNotStandInADoorway) {
  const auto truth = plan_of({{20, 20, 100, 80}, {82, 80, 100, 86}});
  const auto plan = plan_of({{20, 20, 100, 80}, {82, 80, 100, 110}});
  const auto stands = plan_rooms(truth, plan, 0.05).at(0).stands;
  ASSERT_EQ(stands.size(), 3u);
  for (const Point2& stand : stands) EXPECT_GT(stand.y(), 2.0 + 0.25);
}

TEST(PlanRooms, RefusesImagesOfDifferentSizes) {
  simulator::GreyImage smaller = plan_of({{20, 20, 100, 80}});
  smaller.rows -= 1;
  EXPECT_THROW(plan_rooms(plan_of({{20, 20, 100, 80}}), smaller, 0.05), std::invalid_argument);
}

TEST(SmallestRectangle, TurnsWithThePoints) {
  std::vector<Point2> points;
  for (const double x : {-2.0, 0.3, 2.0})
    for (const double y : {-1.0, 1.0}) points.push_back(Pose2{1.0, 2.0, 0.4} * Point2(x, y));
  const Rectangle r = smallest_rectangle(points);
  EXPECT_NEAR(r.yaw_rad, 0.4, 1e-9);
  EXPECT_NEAR(r.width_m, 4.0, 1e-9);
  EXPECT_NEAR(r.height_m, 2.0, 1e-9);
  EXPECT_EQ(smallest_rectangle({{1.0, 1.0}}).area_m2(), 0.0);
}

}  // namespace
}  // namespace enfilade::evaluate
