// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interfaces/geometry/pose2.hpp"
#include "tools/simulator/core/random.hpp"

namespace enfilade::simulator {

/// The nominal figures are those that motorControl computes odometry with; the scales make the true robot
/// differ from them.
struct DriveConfig {
  double wheel_radius_m = 0.08;       ///< nominal, > 0
  double track_m = 0.34;              ///< nominal distance between the wheels, > 0
  double max_wheel_rad_s = 8.0;       ///< what the motors can do, > 0
  double max_wheel_rad_s2 = 25.0;     ///< > 0
  double left_radius_scale = 1.0028;  ///< true ÷ nominal radius
  double right_radius_scale = 1.0032;
  double track_scale = 1.0070;  ///< true ÷ nominal track
  double slip_m_per_sqrt_m =
      0.0008;  ///< σ of the way a wheel slips on the first metre; grows with the root of the way
  int encoder_ticks_per_turn = 8192;  ///< 0 = no quantisation
};

/// How far the base moved in one step, in its own frame at the step's start.
struct DriveStep {
  double forward_m = 0.0;
  double turn_rad = 0.0;

  /// Exact integration: the motion is an arc of a circle.
  Pose2 from(const Pose2& T_world_base) const;
};

/// Two motors with limited acceleration on two slightly wrong wheels.
class Drive {
 public:
  explicit Drive(const DriveConfig& config);

  void command(double left_rad_s, double right_rad_s);
  DriveStep step(double dt_s, Random& random);

  /// What the encoders read.
  double left_rad() const { return quantised(left_.angle_rad); }
  double right_rad() const { return quantised(right_.angle_rad); }

 private:
  struct Wheel {
    double command_rad_s = 0.0;
    double speed_rad_s = 0.0;
    double angle_rad = 0.0;
  };

  /// Turns the wheel; returns the way its rim went over the ground.
  double turn(Wheel& wheel, double radius_m, double dt_s, Random& random) const;
  double quantised(double angle_rad) const;

  DriveConfig config_;
  Wheel left_, right_;
};

}  // namespace enfilade::simulator
