// SPDX-License-Identifier: Apache-2.0
#include "interfaces/geometry/rectangle.hpp"

#include <gtest/gtest.h>

#include "interfaces/model/room.hpp"

namespace enfilade {
namespace {

const Rectangle kRoom{.yaw_rad = 0.3, .x_m = 1.0, .y_m = -2.0, .width_m = 4.2, .height_m = 3.78};

TEST(Rectangle, WallsRunCounterClockwiseWithOutwardNormals) {
  for (int i = 0; i < 4; ++i) {
    const Segment wall = kRoom.wall(i);
    EXPECT_NEAR(wall.length(), kRoom.wall_length_m(i), 1e-12);
    EXPECT_NEAR(wall.direction().dot(kRoom.normal(i)), 0.0, 1e-12);
    EXPECT_GT((wall.midpoint() - kRoom.pose().translation()).dot(kRoom.normal(i)), 0.0);
    EXPECT_NEAR((kRoom.wall((i + 1) % 4).from - wall.to).norm(), 0.0, 1e-12);
  }
}

TEST(Rectangle, CanonicalFormKeepsTheSamePointsAndTellsWhichWallIsWhich) {
  for (double yaw = -7.0; yaw < 7.0; yaw += 0.37) {
    Rectangle r = kRoom;
    r.yaw_rad = yaw;
    const auto [same, turns] = canonical(r);
    EXPECT_GE(same.yaw_rad, -kPi / 4);
    EXPECT_LT(same.yaw_rad, kPi / 4);
    EXPECT_NEAR(iou(r, same), 1.0, 1e-9);
    for (int i = 0; i < 4; ++i) {
      const Point2 expected = r.wall((i - turns + 4) % 4).midpoint();
      EXPECT_NEAR((same.wall(i).midpoint() - expected).norm(), 0.0, 1e-9);
    }
  }
}

TEST(Rectangle, IouOfShiftedCopyIsTheShareOfTheStrip) {
  const Rectangle a{.width_m = 4.0, .height_m = 2.0};
  EXPECT_NEAR(iou(a, Rectangle{.x_m = 1.0, .width_m = 4.0, .height_m = 2.0}), 6.0 / 10.0, 1e-12);
  EXPECT_NEAR(iou(a, Rectangle{.x_m = 9.0, .width_m = 4.0, .height_m = 2.0}), 0.0, 1e-12);
  EXPECT_NEAR(iou(a, Rectangle{.yaw_rad = kPi / 2, .width_m = 2.0, .height_m = 4.0}), 1.0, 1e-12);
}

TEST(Pose2, InverseUndoesAndNamesCancel) {
  const Pose2 T_a_b{1.0, 2.0, 2.5}, T_b_c{-3.0, 0.5, 1.7};
  const Point2 p_c(0.4, -0.9);
  EXPECT_NEAR(((T_a_b * T_b_c) * p_c - T_a_b * (T_b_c * p_c)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(((T_a_b.inverse() * T_a_b) * p_c - p_c).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace enfilade
