// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "interfaces/geometry/angles.hpp"

namespace enfilade {

using Point2 = Eigen::Vector2d;

/// A planar rigid motion. `T_a_b` maps coordinates of b into a: `p_a = T_a_b * p_b`, so that names cancel.
/// Restricted to the plane this is the paper's T_r (eq. 17).
struct Pose2 {
  double x_m = 0.0;
  double y_m = 0.0;
  double yaw_rad = 0.0;

  Point2 translation() const { return {x_m, y_m}; }

  Pose2 inverse() const {
    const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
    return {-c * x_m - s * y_m, s * x_m - c * y_m, -yaw_rad};
  }

  bool operator==(const Pose2&) const = default;
};

inline Point2 rotate(double yaw_rad, const Point2& p) {
  const double c = std::cos(yaw_rad), s = std::sin(yaw_rad);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

inline Point2 operator*(const Pose2& T_a_b, const Point2& p_b) {
  return T_a_b.translation() + rotate(T_a_b.yaw_rad, p_b);
}

inline Pose2 operator*(const Pose2& T_a_b, const Pose2& T_b_c) {
  const Point2 t = T_a_b * T_b_c.translation();
  return {t.x(), t.y(), wrap_to_pi(T_a_b.yaw_rad + T_b_c.yaw_rad)};
}

/// The pose a share `t` of the way from `a` (t = 0) to `b` (t = 1), turning the short way round.
inline Pose2 interpolate(const Pose2& a, const Pose2& b, double t) {
  return {a.x_m + t * (b.x_m - a.x_m), a.y_m + t * (b.y_m - a.y_m),
          wrap_to_pi(a.yaw_rad + t * wrap_to_pi(b.yaw_rad - a.yaw_rad))};
}

}  // namespace enfilade
