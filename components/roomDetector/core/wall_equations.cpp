// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/wall_equations.hpp"

#include <cmath>

namespace enfilade::room_detector {

double tukey(double residual_m, double gate_m) {
  const double u = residual_m / gate_m;
  return std::abs(u) < 1.0 ? (1.0 - u * u) * (1.0 - u * u) : 0.0;
}

WallSight sight_of(const Point2& q, const Rectangle& r, double gate_m, double corner_m) {
  const Point2 local = rotate(-r.yaw_rad, q - Point2(r.x_m, r.y_m));
  // Outward and along (counter-clockwise) coordinates of walls 0 … 3.
  const std::array<double, 4> out{local.x(), local.y(), -local.x(), -local.y()};
  const std::array<double, 4> along{local.y(), -local.x(), -local.y(), local.x()};
  WallSight best{-1, gate_m, 0.0};
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const double distance = i % 2 == 0 ? 0.5 * r.width_m : 0.5 * r.height_m;
    const double residual = out[k] - distance;
    if (std::abs(residual) >= std::abs(best.residual_m)) continue;
    if (std::abs(along[k]) > 0.5 * r.wall_length_m(i) - corner_m) continue;
    best = {i, residual, along[k]};
  }
  return best;
}

WallEquations wall_equations(std::span<const WallPoint> points, const Rectangle& r, double gate_m,
                             double corner_m) {
  WallEquations e;
  for (const WallPoint& point : points) {
    const WallSight s = sight_of(point.position, r, gate_m, corner_m);
    if (s.wall < 0) continue;
    const double w = point.weight * tukey(s.residual_m, gate_m);
    // n_i(α + δα) ≈ n_i + δα t_i: the residual after the step is residual + δα · along − δo_i.
    WallStep j = WallStep::Zero();
    j[0] = s.along_m;
    j[1 + s.wall] = -1.0;
    e.normal += w * j * j.transpose();
    e.rhs -= w * s.residual_m * j;
    e.support[static_cast<std::size_t>(s.wall)] += point.weight;
    e.weight += w;
    e.squares += w * s.residual_m * s.residual_m;
  }
  return e;
}

Rectangle moved(const Rectangle& r, const WallStep& step) {
  Rectangle out = r;
  out.yaw_rad += step[0];
  const Point2 shift = rotate(out.yaw_rad, {0.5 * (step[1] - step[3]), 0.5 * (step[2] - step[4])});
  out.x_m += shift.x();
  out.y_m += shift.y();
  out.width_m += step[1] + step[3];
  out.height_m += step[2] + step[4];
  return out;
}

WallMatrix parameters_by_step(const Rectangle& r) {
  const double c = 0.5 * std::cos(r.yaw_rad), s = 0.5 * std::sin(r.yaw_rad);
  WallMatrix m;
  m << 1, 0, 0, 0, 0,   //
      0, c, -s, -c, s,  //
      0, s, c, -s, -c,  //
      0, 1, 0, 1, 0,    //
      0, 0, 1, 0, 1;
  return m;
}

}  // namespace enfilade::room_detector
