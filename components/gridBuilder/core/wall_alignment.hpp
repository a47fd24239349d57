// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "interfaces/geometry/rectangle.hpp"

namespace enfilade::grid_builder {

struct WallAlignmentConfig {
  double first_gate_m = 0.25, last_gate_m = 0.04;
  double corner_m = 0.15;
  double sigma_m = 0.02;
  double search_rad = 0.0;  ///< the points may be turned by so much either way; small turns are found anyhow
};

/// A room's rectangle, and which of its walls have been seen: the others are only where it had to be closed.
struct KnownWalls {
  Rectangle rectangle;
  std::array<bool, 4> seen{true, true, true, true};
};

/// The motion that brings points onto the walls of a rectangle.
struct WallAlignment {
  Pose2 T_after_before;        ///< to be applied to the points
  Eigen::Matrix3d covariance;  ///< of `pivot` and yaw; a metre or a radian where the points tell nothing
  double sigma_m = 0.0;        ///< of the position of `pivot`, in the direction known least
  double sigma_rad = 0.0;
  double on_walls_share =
      0.0;  ///< of the points within the first gate of a wall that came to lie within the last
};

/// Robust point-to-line least squares: minimises Σ ρ(n_i · (R(δ)(q − pivot) + pivot + t − c) − o_i) over t
/// and δ, Tukey's ρ with a gate that narrows, from the turn within ±`search_rad` that brings most points to
/// walls. `pivot` is about where the points were seen from. Where the points tell nothing, nothing moves.
/// Empty where no point is near a wall that was seen.
std::optional<WallAlignment> align_to_walls(std::span<const Point2> points, const KnownWalls& walls,
                                            const Point2& pivot, const WallAlignmentConfig& config);

}  // namespace enfilade::grid_builder
