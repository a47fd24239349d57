// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "interfaces/geometry/pose2.hpp"

namespace enfilade::room_detector {

/// What lies on the kept side of a few lines; at first the whole plane.
class ConvexRegion {
 public:
  static constexpr std::size_t kMostLines = 4;

  /// Keeps what lies on the side of the line through `point` that `inwards` (a unit vector) points to. Of
  /// more than kMostLines lines the last ones are not heeded.
  ConvexRegion& cut(const Point2& point, const Point2& inwards) {
    if (count_ < kMostLines) lines_[count_++] = {inwards, inwards.dot(point)};
    return *this;
  }

  bool contains(const Point2& p) const { return may_meet(p, 0.0); }
  /// False only where no point of the disc is contained.
  bool may_meet(const Point2& centre, double radius_m) const {
    for (std::size_t i = 0; i < count_; ++i)
      if (lines_[i].inwards.dot(centre) < lines_[i].from_m - radius_m) return false;
    return true;
  }

 private:
  struct Line {
    Point2 inwards = Point2::Zero();
    double from_m = 0.0;
  };
  std::array<Line, kMostLines> lines_;
  std::size_t count_ = 0;
};

}  // namespace enfilade::room_detector
