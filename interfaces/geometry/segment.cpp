// SPDX-License-Identifier: Apache-2.0
#include "interfaces/geometry/segment.hpp"

#include <algorithm>

namespace enfilade {

double interval_iou(double from_a, double to_a, double from_b, double to_b) {
  const double overlap = std::min(to_a, to_b) - std::max(from_a, from_b);
  const double hull = std::max(to_a, to_b) - std::min(from_a, from_b);
  return overlap > 0.0 && hull > 0.0 ? overlap / hull : 0.0;
}

double distance(const Point2& p, const Segment& s) {
  const Point2 along = s.to - s.from;
  const double squared = along.squaredNorm();
  const double t = squared > 0.0 ? std::clamp((p - s.from).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (p - s.from - t * along).norm();
}

}  // namespace enfilade
