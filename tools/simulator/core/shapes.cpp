// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/shapes.hpp"

#include <algorithm>
#include <limits>

namespace enfilade::simulator {
namespace {

constexpr int kCircleSides = 32;
/// What is not higher than this is driven over.
constexpr double kFlat_m = 0.01;

double cross(const Point2& a, const Point2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

std::vector<Point2> outline(const Rectangle& rectangle) {
  const auto corners = rectangle.corners();
  return {corners.begin(), corners.end()};
}

std::vector<Point2> circle_outline(const Point2& centre, double diameter_m) {
  std::vector<Point2> polygon;
  for (int i = 0; i < kCircleSides; ++i)
    polygon.push_back(centre + rotate(2.0 * kPi * i / kCircleSides, {0.5 * diameter_m, 0.0}));
  return polygon;
}

std::vector<Point2> shifted(std::vector<Point2> polygon, const Point2& offset) {
  for (Point2& p : polygon) p += offset;
  return polygon;
}

double distance(const Point2& p, const std::vector<Point2>& polygon) {
  bool inside = true;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment side{polygon[i], polygon[(i + 1) % polygon.size()]};
    inside = inside && cross(side.to - side.from, p - side.from) >= 0.0;
    nearest_m = std::min(nearest_m, enfilade::distance(p, side));
  }
  return inside ? 0.0 : nearest_m;
}

bool in_the_way(const Solid& solid, double height_m) {
  return solid.bottom_m < height_m && solid.top_m > kFlat_m;
}

}  // namespace enfilade::simulator
