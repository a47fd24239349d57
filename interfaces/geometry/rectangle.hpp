// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "interfaces/geometry/pose2.hpp"
#include "interfaces/geometry/segment.hpp"

namespace enfilade {

/// The paper's r = (α, x_c, y_c, w, h), in the frame its user names.
///
/// `width_m` is the extent along the rectangle's own x axis (direction α), `height_m` along its y axis, so
/// that the frame of eq. 17 and the sizes agree. Walls and corners count counter-clockwise: wall i has the
/// outward normal α + i·π/2 and runs from corner(i) to corner(i + 1); wall 0 is x = +width/2, wall 1 y =
/// +height/2, and so on.
struct Rectangle {
  double yaw_rad = 0.0;
  double x_m = 0.0;
  double y_m = 0.0;
  double width_m = 0.0;
  double height_m = 0.0;

  /// F_r: origin at the centre, x along the width (eq. 17).
  Pose2 pose() const { return {x_m, y_m, yaw_rad}; }
  Point2 corner(int i) const;
  std::array<Point2, 4> corners() const { return {corner(0), corner(1), corner(2), corner(3)}; }
  Segment wall(int i) const { return {corner(i), corner(i + 1)}; }
  double wall_length_m(int i) const { return i % 2 == 0 ? height_m : width_m; }
  /// Outward unit normal of wall i.
  Point2 normal(int i) const { return rotate(yaw_rad + 0.5 * kPi * i, {1.0, 0.0}); }
  double area_m2() const { return width_m * height_m; }
  /// Whether `p` is inside, at least `margin_m` away from every wall (negative: that much outside still
  /// counts).
  bool contains(const Point2& p, double margin_m = 0.0) const;

  bool operator==(const Rectangle&) const = default;
};

/// The rectangle seen from frame a, given in frame b.
Rectangle operator*(const Pose2& T_a_b, const Rectangle& r_b);

/// The same set of points with yaw in [-π/4, π/4), sides renamed accordingly. `quarter_turns` tells how many
/// quarter turns were taken off the yaw: wall i of the result was wall (i - quarter_turns) mod 4 of the
/// argument.
struct CanonicalRectangle {
  Rectangle rectangle;
  int quarter_turns = 0;
};
CanonicalRectangle canonical(const Rectangle& r);

/// Area of the intersection over area of the union.
double iou(const Rectangle& a, const Rectangle& b);

}  // namespace enfilade
