// SPDX-License-Identifier: Apache-2.0
#include "interfaces/geometry/rectangle.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace enfilade {
namespace {

double polygon_area(const std::vector<Point2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& p = polygon[i];
    const Point2& q = polygon[(i + 1) % polygon.size()];
    twice += p.x() * q.y() - q.x() * p.y();
  }
  return 0.5 * std::abs(twice);
}

/// Sutherland–Hodgman: what of the polygon lies on the inner side of wall i of `r`.
std::vector<Point2> clip(const std::vector<Point2>& polygon, const Rectangle& r, int i) {
  const Point2 normal = r.normal(i);
  const double limit = normal.dot(r.corner(i));
  std::vector<Point2> kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point2& p = polygon[k];
    const Point2& q = polygon[(k + 1) % polygon.size()];
    const double p_out = normal.dot(p) - limit;
    const double q_out = normal.dot(q) - limit;
    if (p_out <= 0.0) kept.push_back(p);
    if ((p_out < 0.0 && q_out > 0.0) || (p_out > 0.0 && q_out < 0.0))
      kept.push_back(p + p_out / (p_out - q_out) * (q - p));
  }
  return kept;
}

}  // namespace

Point2 Rectangle::corner(int i) const {
  static constexpr std::array<std::pair<int, int>, 4> kSigns{{{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}};
  const auto [sx, sy] = kSigns[static_cast<std::size_t>(((i % 4) + 4) % 4)];
  return pose() * Point2(0.5 * sx * width_m, 0.5 * sy * height_m);
}

bool Rectangle::contains(const Point2& p, double margin_m) const {
  const Point2 local = pose().inverse() * p;
  return std::abs(local.x()) <= 0.5 * width_m - margin_m && std::abs(local.y()) <= 0.5 * height_m - margin_m;
}

Rectangle operator*(const Pose2& T_a_b, const Rectangle& r_b) {
  const Pose2 pose = T_a_b * r_b.pose();
  return {pose.yaw_rad, pose.x_m, pose.y_m, r_b.width_m, r_b.height_m};
}

CanonicalRectangle canonical(const Rectangle& r) {
  CanonicalRectangle out{r, 0};
  out.rectangle.yaw_rad = wrap_to_quarter(r.yaw_rad);
  const long turns = std::lround((r.yaw_rad - out.rectangle.yaw_rad) / (0.5 * kPi));
  out.quarter_turns = static_cast<int>(((turns % 4) + 4) % 4);
  if (out.quarter_turns % 2 != 0) std::swap(out.rectangle.width_m, out.rectangle.height_m);
  return out;
}

double iou(const Rectangle& a, const Rectangle& b) {
  const auto corners = a.corners();
  std::vector<Point2> shared(corners.begin(), corners.end());
  for (int i = 0; i < 4 && !shared.empty(); ++i) shared = clip(shared, b, i);
  const double intersection = shared.empty() ? 0.0 : polygon_area(shared);
  const double hull = a.area_m2() + b.area_m2() - intersection;
  return hull > 0.0 ? intersection / hull : 0.0;
}

}  // namespace enfilade
