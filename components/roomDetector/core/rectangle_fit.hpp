// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "components/roomDetector/core/hit_map.hpp"
#include "interfaces/model/room.hpp"

namespace enfilade::room_detector {

struct RectangleFitConfig {
  double first_gate_m =
      0.12;  ///< points farther from a wall than this do not belong to it (Tukey), at first …
  double last_gate_m = 0.04;  ///< … and at last
  double corner_m = 0.15;     ///< so near a corner a point may belong to either wall, and counts for none
  int iterations = 14;
  double min_wall_weight = 30.0;  ///< a wall with fewer measurements stays where it was
};

/// A rectangle fitted to points.
struct RectangleFit {
  Rectangle rectangle;
  Eigen::Matrix<double, 5, 5> covariance =
      Eigen::Matrix<double, 5, 5>::Zero();  ///< of (α, x_c, y_c, w, h), statistical only
  Eigen::Matrix<double, 5, 1> per_range_bias =
      Eigen::Matrix<double, 5, 1>::Zero();  ///< how they move for each metre the laser measures too much
  std::array<double, 4> support{};          ///< measurements within the last gate, by wall
  double rms_m = 0.0;                       ///< of their distances to their walls

  double total_support() const { return support[0] + support[1] + support[2] + support[3]; }
};

/// Robust least squares of rectangles: minimises Σ ρ(n_i(α) · (q − c) − o_i) over the points q near wall i,
/// where n_i is the outward normal of wall i and o_i its distance from the centre c.
class RectangleFitter {
 public:
  explicit RectangleFitter(const RectangleFitConfig& config);

  /// Moves all four walls and α. `reach_m` is how far a wall may lie from where it is thought to be. Empty
  /// where the points support the result clearly less than they support the start.
  std::optional<RectangleFit> fit(std::span<const WallPoint> points, const Rectangle& start,
                                  double reach_m) const;
  /// Moves the rectangle as a whole, sizes held (r(i+1) of eq. 18–19). Empty unless two perpendicular walls
  /// are seen.
  std::optional<RectangleFit> fit_pose(std::span<const WallPoint> points, const Rectangle& start,
                                       double reach_m) const;

 private:
  RectangleFitConfig config_;
};

}  // namespace enfilade::room_detector
