// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interfaces/geometry/pose2.hpp"
#include "interfaces/model/motion.hpp"

namespace enfilade::motor_control {

struct DifferentialDriveConfig {
  double wheel_radius_m = 0.08;  ///< > 0
  double track_m = 0.34;         ///< distance between the wheels' contact points, > 0
};

/// A value for each of the two driven wheels: angles (rad) or rates (rad/s).
struct Wheels {
  double left = 0.0;
  double right = 0.0;
};

/// Kinematics of a base with two driven wheels on one axle.
class DifferentialDrive {
 public:
  explicit DifferentialDrive(const DifferentialDriveConfig& config);

  /// Wheel rates (rad/s) that give the base this speed.
  Wheels wheel_rates(const VelocityCommand& base) const;
  /// Speed of the base whose wheels turn at these rates (rad/s).
  VelocityCommand base_speed(const Wheels& rates_rad_s) const;
  /// Where the base goes, in its own frame, while the wheels turn by these angles (rad), each at a steady
  /// rate: an exact arc.
  Pose2 arc(const Wheels& turned_rad) const;

 private:
  DifferentialDriveConfig config_;
};

}  // namespace enfilade::motor_control
