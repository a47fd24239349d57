// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "components/roomDetector/core/joint_equations.hpp"

namespace enfilade::room_detector {

/// What a fit has come to.
struct FittedStands {
  std::span<const StandPoints> stands;
  const std::vector<Pose2>& corrections;
  const Rectangle& rectangle;
  double variance;                       ///< of one return (m²)
  const Eigen::VectorXd& step_per_bias;  ///< how the unknowns move for each metre the laser measures too much
};

/// What the covariance of the right-hand side (m²) is more than the noise of returns makes it. What makes a
/// stretch of a wall stand out or back, such as a frame, a lintel or the edge of a niche, moves all of its
/// points alike, however many there are: Σ_c (1 − v_c / s_c²) g_c g_cᵀ over those stretches c whose residuals
/// are more than noise, with g_c = Σ w ρ J, s_c = Σ w ρ and v_c the variance that noise gives s_c. What a
/// range bias bends is taken off the residuals first.
Eigen::MatrixXd unevenness(const FittedStands& fit, const RectangleFitConfig& config);

}  // namespace enfilade::room_detector
