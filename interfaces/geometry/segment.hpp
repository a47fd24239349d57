// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "interfaces/geometry/pose2.hpp"

namespace enfilade {

/// A directed line segment in the plane.
struct Segment {
  Point2 from = Point2::Zero();
  Point2 to = Point2::Zero();

  double length() const { return (to - from).norm(); }
  Point2 midpoint() const { return 0.5 * (from + to); }
  Point2 direction() const { return (to - from).normalized(); }
};

inline Segment operator*(const Pose2& T_a_b, const Segment& s_b) {
  return {T_a_b * s_b.from, T_a_b * s_b.to};
}

/// Overlap of two intervals divided by their union; 0 where they do not meet.
double interval_iou(double from_a, double to_a, double from_b, double to_b);

/// Distance from a point to the nearest point of the segment.
double distance(const Point2& p, const Segment& s);

}  // namespace enfilade
