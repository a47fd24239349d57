// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>

#include "components/motorControl/core/differential_drive.hpp"
#include "interfaces/model/zone_tag.hpp"

namespace enfilade::motor_control {

struct WheelOdometryConfig {
  double speed_window_s = 0.025;      ///< speeds are means over this time, >= 0.005
  double still_linear_m_s = 0.005;    ///< slower counts as standing
  double still_angular_rad_s = 0.01;  ///< slower counts as standing
  double settle_s = 0.1;              ///< how long the base must stand before it counts as standing still
};

/// Dead reckoning from the encoders of the wheels. The pose starts at the origin and never jumps.
class WheelOdometry {
 public:
  WheelOdometry(const WheelOdometryConfig& config, const DifferentialDrive& drive);

  /// `stamp_ns` later than the last one.
  void update(StampNs stamp_ns, const Wheels& angles_rad);

  const Pose2& T_odom_base() const { return T_odom_base_; }
  VelocityCommand speed() const { return speed_; }
  bool moving() const { return moving_; }

 private:
  struct Sample {
    StampNs stamp_ns = 0;
    Wheels angles_rad;
  };

  void measure_speed();

  WheelOdometryConfig config_;
  DifferentialDrive drive_;
  std::deque<Sample> window_;
  Pose2 T_odom_base_;
  VelocityCommand speed_;
  StampNs last_moved_ns_ = 0;
  bool moving_ = false;
};

}  // namespace enfilade::motor_control
