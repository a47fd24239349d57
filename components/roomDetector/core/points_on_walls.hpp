// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "components/roomDetector/core/point_mover.hpp"
#include "components/roomDetector/core/rectangle_fit.hpp"
#include "components/roomDetector/core/wall_equations.hpp"

namespace enfilade::room_detector {

/// What was measured from one stand, where odometry had it.
struct StandPoints {
  Pose2 T_zone_base;
  std::vector<WallPoint> points;
};

/// A point that counts for a wall, and how much.
struct PointOnWall {
  int wall;
  double along_m, residual_m;
  double weight, w;  ///< returns it stands for; that times Tukey's weight
  double beam;       ///< ∂ρ/∂range
  double noise;  ///< w² σ² / weight, σ of one return along the wall's normal in units of that of the range
};

template <class Visit>
void visit_points(const StandPoints& stand, const Pose2& correction, const Rectangle& r,
                  const RectangleFitConfig& config, Visit&& visit) {
  const PointMover move(correction);
  const WallSights sights(r, config.last_gate_m, config.corner_m);
  const std::array<Point2, 4> normals{r.normal(0), r.normal(1), r.normal(2), r.normal(3)};
  for (const WallPoint& point : stand.points) {
    const WallSight sight = sights.of(move(point.position));
    if (sight.wall < 0) continue;
    const double share = tukey(sight.residual_m, config.last_gate_m), w = point.weight * share;
    const double beam = normals[static_cast<std::size_t>(sight.wall)].dot(move.turned(point.per_range));
    const double slant = point.per_range.isZero() ? 1.0 : beam * beam;
    visit(PointOnWall{sight.wall, sight.along_m, sight.residual_m, point.weight, w, beam, w * share * slant});
  }
}

/// What points of one stand on one wall, or a stretch of it, add up to. Σ x stands for (Σ x, Σ x t, Σ x t²),
/// t along the wall: all that is needed of them, as the row of a point's Jacobian is a line in t.
struct WallSums {
  Eigen::Vector3d weights = Eigen::Vector3d::Zero(), noises = weights;     ///< Σ w, Σ w² σ² / weight
  Eigen::Vector2d residuals = Eigen::Vector2d::Zero(), beams = residuals;  ///< Σ w ρ, Σ w ∂ρ/∂range
  double support = 0.0, squares = 0.0;                                     ///< Σ weight, Σ w ρ²

  void add(const PointOnWall& point) {
    const Eigen::Vector3d powers(1.0, point.along_m, point.along_m * point.along_m);
    weights += point.w * powers;
    noises += point.noise * powers;
    residuals += point.w * point.residual_m * powers.head<2>();
    beams += point.w * point.beam * powers.head<2>();
    support += point.weight;
    squares += point.w * point.residual_m * point.residual_m;
  }
};

inline Point2 left_of(const Point2& v) { return {-v.y(), v.x()}; }

/// The row of the Jacobian of a point `t` along a wall, over (δα, δo_wall, δx, δy, δψ), is at_centre + t ·
/// per_metre.
struct JacobianLine {
  Eigen::Matrix<double, 5, 1> at_centre, per_metre;

  /// Σ x j, of (Σ x, Σ x t).
  Eigen::Matrix<double, 5, 1> sum(const Eigen::Vector2d& x) const {
    return x[0] * at_centre + x[1] * per_metre;
  }
  /// Σ x j jᵀ, of (Σ x, Σ x t, Σ x t²).
  Eigen::Matrix<double, 5, 5> squares(const Eigen::Vector3d& x) const {
    const Eigen::Matrix<double, 5, 5> mixed = at_centre * per_metre.transpose();
    return x[0] * at_centre * at_centre.transpose() + x[1] * (mixed + mixed.transpose()) +
           x[2] * per_metre * per_metre.transpose();
  }
};

/// With t = left(n) a turn of the stand about `base` moves a point q along n by n · left(q − base) =
/// −t · (q − base).
inline JacobianLine jacobian_of(const Rectangle& r, int wall, const Point2& base) {
  const Point2 n = r.normal(wall), t = left_of(n);
  JacobianLine line;
  line.at_centre << 0.0, -1.0, n, t.dot(base - Point2(r.x_m, r.y_m));
  line.per_metre << 1.0, 0.0, 0.0, 0.0, -1.0;
  return line;
}

}  // namespace enfilade::room_detector
