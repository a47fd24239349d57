// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/wall_equations.hpp"

#include <cmath>

namespace enfilade::room_detector {

double tukey(double residual_m, double gate_m) {
  const double u = residual_m / gate_m;
  return std::abs(u) < 1.0 ? (1.0 - u * u) * (1.0 - u * u) : 0.0;
}

WallSights::WallSights(const Rectangle& r, double gate_m, double corner_m)
    : centre_(r.x_m, r.y_m),
      into_rectangle_({0.0, 0.0, -r.yaw_rad}),
      distance_m_{0.5 * r.width_m, 0.5 * r.height_m},
      reach_m_{0.5 * r.wall_length_m(0) - corner_m, 0.5 * r.wall_length_m(1) - corner_m},
      gate_m_(gate_m) {}

/// Of two parallel walls the one on the side of the point is the nearer one.
WallSight WallSights::of(const Point2& q) const {
  const Point2 local = into_rectangle_.turned(q - centre_);
  const double across = std::abs(local.x()), up = std::abs(local.y());
  const double to_x = across - distance_m_[0], to_y = up - distance_m_[1];
  const bool faces_x = std::abs(to_x) < gate_m_ && up <= reach_m_[0],
             faces_y = std::abs(to_y) < gate_m_ && across <= reach_m_[1];
  if (faces_x && !(faces_y && std::abs(to_y) < std::abs(to_x)))
    return local.x() < 0.0 ? WallSight{2, to_x, -local.y()} : WallSight{0, to_x, local.y()};
  if (faces_y) return local.y() < 0.0 ? WallSight{3, to_y, local.x()} : WallSight{1, to_y, -local.x()};
  return {-1, gate_m_, 0.0};
}

WallEquations wall_equations(std::span<const WallPoint> points, const Rectangle& r, double gate_m,
                             double corner_m) {
  WallEquations e;
  const WallSights sights(r, gate_m, corner_m);
  for (const WallPoint& point : points) {
    const WallSight s = sights.of(point.position);
    if (s.wall < 0) continue;
    const double w = point.weight * tukey(s.residual_m, gate_m);
    // n_i(α + δα) ≈ n_i + δα t_i: the residual after the step is residual + δα · along − δo_i. The row
    // of the Jacobian has two entries: along for δα, −1 for δo_i.
    const int o = 1 + s.wall;
    const double w_along = w * s.along_m, w_residual = w * s.residual_m;
    e.normal(0, 0) += w_along * s.along_m;
    e.normal(0, o) -= w_along;
    e.normal(o, 0) -= w_along;
    e.normal(o, o) += w;
    e.rhs[0] -= w_residual * s.along_m;
    e.rhs[o] += w_residual;
    e.support[static_cast<std::size_t>(s.wall)] += point.weight;
    e.weight += w;
    e.squares += w_residual * s.residual_m;
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
