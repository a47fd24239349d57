// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "interfaces/geometry/pose2.hpp"

namespace enfilade::room_detector {

/// T · p for many points: bit for bit what Pose2 gives, with the angle worked out once.
class PointMover {
 public:
  explicit PointMover(const Pose2& T)
      : translation_(T.translation()), cos_(std::cos(T.yaw_rad)), sin_(std::sin(T.yaw_rad)) {}

  Point2 operator()(const Point2& p) const { return translation_ + turned(p); }
  Point2 turned(const Point2& p) const { return {cos_ * p.x() - sin_ * p.y(), sin_ * p.x() + cos_ * p.y()}; }

 private:
  Point2 translation_;
  double cos_, sin_;
};

}  // namespace enfilade::room_detector
