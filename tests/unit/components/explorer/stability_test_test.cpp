// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/stability_test.hpp"

#include <gtest/gtest.h>

#include "components/explorer/core/rectangle_naming.hpp"

namespace enfilade::explorer {
namespace {

RoomEstimate estimate(const Rectangle& r, int doors = 1) {
  RoomEstimate e{.found = true, .rectangle = r};
  e.doors.assign(static_cast<std::size_t>(doors), DoorEstimate{.state = DoorState::kOpen});
  return e;
}

constexpr Rectangle kRectangle{0.1, 1.0, 2.0, 4.0, 3.0};

TEST(StabilityTest, HoldsWhenNothingChanges) {
  StabilityTest test({});
  EXPECT_FALSE(test.update(estimate(kRectangle)));
  EXPECT_TRUE(test.update(estimate(kRectangle)));
}

TEST(StabilityTest, OneWallThatMovesIsAChange) {
  StabilityTest test({});
  test.update(estimate(kRectangle));
  Rectangle grown = kRectangle;  // the wall on the right moves by 12 cm, the others stay
  grown.width_m += 0.12;
  const Point2 shift = rotate(kRectangle.yaw_rad, {0.06, 0.0});
  grown.x_m += shift.x();
  grown.y_m += shift.y();
  const auto shifts = wall_shifts_m(kRectangle, grown);
  EXPECT_NEAR(shifts[0], 0.12, 1e-9);
  EXPECT_NEAR(shifts[1], 0.0, 1e-9);
  EXPECT_NEAR(shifts[2], 0.0, 1e-9);
  EXPECT_FALSE(test.update(estimate(grown)));
  EXPECT_TRUE(test.update(estimate(grown)));
}

TEST(StabilityTest, OtherNamesForTheSameSidesAreNoChange) {
  StabilityTest test({});
  test.update(estimate(kRectangle));
  EXPECT_TRUE(test.update(estimate({kRectangle.yaw_rad - 0.5 * kPi, 1.0, 2.0, 3.0, 4.0})));
  EXPECT_TRUE(test.update(estimate({wrap_to_pi(kRectangle.yaw_rad + kPi), 1.0, 2.0, 4.0, 3.0})));
}

TEST(StabilityTest, ANewDoorIsAChange) {
  StabilityTest test({});
  test.update(estimate(kRectangle, 1));
  EXPECT_FALSE(test.update(estimate(kRectangle, 2)));
}

TEST(StabilityTest, ALostRoomStartsAgain) {
  StabilityTest test({});
  test.update(estimate(kRectangle));
  test.update({});
  EXPECT_FALSE(test.update(estimate(kRectangle)));
}

}  // namespace
}  // namespace enfilade::explorer
