// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "interfaces/geometry/rectangle.hpp"

namespace enfilade::grid_builder {

struct WallAlignmentConfig {
  double first_gate_m = 0.25, last_gate_m = 0.04;
  double corner_m = 0.15;
  double sigma_m = 0.02;
};

/// The motion that brings points onto the walls of a rectangle.
struct WallAlignment {
  Pose2 T_after_before;  ///< to be applied to the points
  double sigma_m = 0.0;  ///< of the position of `pivot`, in the direction known least
  double sigma_rad = 0.0;
  double on_walls_share =
      0.0;  ///< of the points within the first gate of a wall that came to lie within the last
};

/// Robust point-to-line least squares: minimises Σ ρ(n_i · (R(δ)(q − pivot) + pivot + t − c) − o_i) over t
/// and δ, Tukey's ρ with a gate that narrows. `pivot` is about where the points were seen from. Empty where
/// the points do not tell all three.
std::optional<WallAlignment> align_to_walls(std::span<const Point2> points, const Rectangle& walls,
                                            const Point2& pivot, const WallAlignmentConfig& config);

}  // namespace enfilade::grid_builder
