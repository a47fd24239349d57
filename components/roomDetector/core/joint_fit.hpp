// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "components/roomDetector/core/joint_equations.hpp"
#include "components/roomDetector/core/rectangle_fit.hpp"

namespace enfilade::room_detector {

struct JointFit {
  RectangleFit room;
  std::vector<Pose2> corrections;  ///< T_zone_odom of each stand; the first one's is the identity
};

/// One rectangle for several stands whose poses odometry only knows roughly: minimises
///   Σ_k Σ_q ρ(n_i(α) · (T_k q − c) − o_i) + Σ_k |T_k ⊖ T_{k−1}|²_motion
/// over the rectangle and the correction T_k of every stand but the first.
class JointFitter {
 public:
  JointFitter(const JointFitConfig& config, const RectangleFitConfig& fit);

  /// Empty where the points of the first stands do not support a rectangle near `start`.
  std::optional<JointFit> fit(std::span<const StandPoints> stands, const Rectangle& start,
                              double reach_m) const;

 private:
  struct Problem;
  void align(std::span<const StandPoints> stands, Problem& problem) const;
  WallMatrix spread_by_bias(std::span<const StandPoints> stands, const Problem& problem,
                            const WallStep& per_bias) const;

  JointFitConfig config_;
  RectangleFitConfig fit_config_;
  RectangleFitter fitter_;
};

}  // namespace enfilade::room_detector
