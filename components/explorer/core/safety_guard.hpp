// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "interfaces/geometry/pose2.hpp"
#include "interfaces/model/motion.hpp"
#include "interfaces/model/sensing.hpp"

namespace enfilade::explorer {

struct SafetyGuardConfig {
  double robot_radius_m = 0.22;
  double side_margin_m = 0.02;
  double ahead_m = 0.05;  ///< kept free in front, besides the way needed to stop
  double deceleration_m_s2 = 0.8;
  double latency_s = 0.15;  ///< from a return to the wheels
  double lowest_m = 0.05;   ///< returns within these heights over the floor count
  double highest_m = 0.75;
};

/// Tells from the newest returns whether a motion would end in something.
class SafetyGuard {
 public:
  explicit SafetyGuard(const SafetyGuardConfig& config);

  /// Returns, in the base frame, that the robot's disc would come too close to before it could stop. Turning
  /// on the spot never touches anything: the body is round. What it moves away from does not stop it.
  std::vector<Point2> in_the_way(const VelocityCommand& velocity, const std::vector<Point3f>& points) const;

 private:
  SafetyGuardConfig config_;
};

}  // namespace enfilade::explorer
