// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

#include "components/roomDetector/core/hit_map.hpp"
#include "components/roomDetector/core/point_mover.hpp"
#include "interfaces/geometry/rectangle.hpp"

namespace enfilade::room_detector {

/// (δα, δo_0 … δo_3): a turn about the centre, and how far each wall moves outwards.
using WallStep = Eigen::Matrix<double, 5, 1>;
using WallMatrix = Eigen::Matrix<double, 5, 5>;
/// m and rad: a step so small shows in no figure.
inline constexpr double kSettled = 1e-6;

/// Tukey's weight of a residual: 1 at none, 0 from the gate on.
double tukey(double residual_m, double gate_m);

/// A point as one wall sees it.
struct WallSight {
  int wall = 0;
  double residual_m = 0.0;  ///< n_i · (q − c) − o_i: outside is positive
  double along_m = 0.0;     ///< t_i · (q − c)
};

/// The wall whose stretch (less `corner_m` at its ends) faces a point, nearest one first; wall -1 where none
/// is within `gate_m`.
class WallSights {
 public:
  WallSights(const Rectangle& r, double gate_m, double corner_m);
  WallSight of(const Point2& q) const;

 private:
  Point2 centre_;
  PointMover into_rectangle_;
  std::array<double, 2> distance_m_, reach_m_;  ///< of walls 0 and 2, of walls 1 and 3
  double gate_m_;
};

/// Normal equations N δ = b of one Gauss–Newton step about `r`.
struct WallEquations {
  WallMatrix normal = WallMatrix::Zero();
  WallStep rhs = WallStep::Zero();
  std::array<double, 4> support{};
  double weight = 0.0, squares = 0.0;  ///< Σ w and Σ w ρ² of the residuals
};
WallEquations wall_equations(std::span<const WallPoint> points, const Rectangle& r, double gate_m,
                             double corner_m);

/// `r` with the step carried out.
Rectangle moved(const Rectangle& r, const WallStep& step);
/// ∂(α, x_c, y_c, w, h) / ∂(δα, δo).
WallMatrix parameters_by_step(const Rectangle& r);

}  // namespace enfilade::room_detector
