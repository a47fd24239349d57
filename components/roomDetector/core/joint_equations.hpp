// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "components/roomDetector/core/points_on_walls.hpp"
#include "components/roomDetector/core/rectangle_fit.hpp"

namespace enfilade::room_detector {

struct JointFitConfig {
  double motion_sigma_m = 0.02;       ///< what odometry errs by from one stand to the next …
  double motion_sigma_deg = 1.0;      ///< … in the mean
  double reach_m = 0.25;              ///< a stand's walls may lie so far from the room's by that
  double range_sigma_m = 0.01;        ///< of one return of the laser
  double range_bias_sigma_m = 0.017;  ///< of the laser; ±30 mm evenly spread: 30 mm / √3
  double wall_sigma_m = 0.00007;      ///< how flat a wall is, and how well a plane describes it
};

/// Unknowns: δα, δo_0 … δo_3 of the rectangle, then (δx, δy, δψ) of each stand but the first, about itself.
inline int first_unknown(std::size_t stand) { return 5 + 3 * (static_cast<int>(stand) - 1); }

/// Normal equations N x = b, what a range bias of 1 m adds to b, and the covariance of b in units of that of
/// one return.
struct JointSystem {
  Eigen::MatrixXd normal;
  Eigen::VectorXd rhs, per_bias;
  Eigen::MatrixXd noise;
  std::array<double, 4> support{};
  double weight = 0.0, squares = 0.0;  ///< Σ w and Σ w ρ² of the residuals
  double variance = 0.0;               ///< of one return

  explicit JointSystem(int unknowns)
      : normal(Eigen::MatrixXd::Zero(unknowns, unknowns)),
        rhs(Eigen::VectorXd::Zero(unknowns)),
        per_bias(Eigen::VectorXd::Zero(unknowns)),
        noise(Eigen::MatrixXd::Zero(unknowns, unknowns)) {}
};

/// Adds the points of stand `index` under its correction, about the rectangle `r`.
void add_stand(JointSystem& s, const StandPoints& stand, const Pose2& correction, std::size_t index,
               const Rectangle& r, const RectangleFitConfig& config);
/// Adds what odometry says: from stand to stand the corrections change little.
void add_motion(JointSystem& s, std::span<const StandPoints> stands, const std::vector<Pose2>& corrections,
                const JointFitConfig& config);
}  // namespace enfilade::room_detector
