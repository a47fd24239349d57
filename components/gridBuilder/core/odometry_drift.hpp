// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Eigen/Core>

#include "interfaces/geometry/pose2.hpp"

namespace enfilade::grid_builder {

struct OdometryDriftConfig {
  double distance_sigma = 0.03;    ///< share by which odometry may tell a distance wrong …
  double turn_sigma = 0.03;        ///< … and a turn, before anything was measured
  double curve_sigma_deg_m = 0.5;  ///< and by which it may miss turning on each metre
  double slip_m = 0.005;           ///< what is different each time: on the first metre, growing with its root
  double slip_deg = 0.3;           ///< likewise, on the first metre or radian
  double place_sigma_m = 0.01;     ///< of a place as told by the walls of a room, their own error included
  double place_sigma_deg = 0.2;
  double gate_sigma = 4.0;  ///< a place farther from where the robot should be is a mistake
};

/// T_zone_odom: where odometry has gone. It errs by a share of each metre and of each turn, which is the same
/// share every time (wheels that are not quite as large as told), and by slip. Whenever the walls of a room
/// tell the robot's place, the first part is estimated from what odometry told since the place before (a
/// Kalman filter over three numbers); from then on it is taken out while the robot moves, also where there
/// are no walls to look at: on the way through a door.
class OdometryDrift {
 public:
  /// Throws std::invalid_argument where the configuration makes no sense.
  explicit OdometryDrift(const OdometryDriftConfig& config);

  /// Odometry has come to `T_odom_base`.
  void move(const Pose2& T_odom_base);
  const Pose2& T_zone_odom() const { return T_zone_odom_; }
  Pose2 T_zone_base() const { return last_ ? T_zone_odom_ * *last_ : T_zone_odom_; }

  /// Of T_zone_base() as x, y and yaw, counted from the last place that was known.
  Eigen::Matrix3d covariance() const { return by_scale_ * P_ * by_scale_.transpose() + by_slip_; }
  /// Walls tell that the robot does not stand at T_zone_base() but at `T_after_before` times it, as surely as
  /// `covariance` of (x, y, yaw) says: the zone's frame keeps, the drift takes it. False, and nothing done,
  /// where odometry cannot have erred so much.
  bool settle(const Pose2& T_after_before, const Eigen::Matrix3d& covariance);
  /// Nothing is known of this place but odometry: a room that is modelled from here hangs on it.
  void begin_here();

  /// Odometry counts from where the robot stands; the wheels are the same.
  void forget_odometry();
  /// The drift is known from elsewhere.
  void start_from(const Pose2& T_zone_odom) { T_zone_odom_ = T_zone_odom; }

  /// True over told: of a distance, and of a turn.
  double distance_scale() const { return 1.0 + scale_[0]; }
  double turn_scale() const { return 1.0 + scale_[1]; }

 private:
  Eigen::Matrix3d place_covariance() const;
  void take(const Eigen::Vector3d& off);

  OdometryDriftConfig config_;
  Pose2 T_zone_odom_;
  std::optional<Pose2> last_;                           ///< T_odom_base
  Eigen::Vector3d scale_ = Eigen::Vector3d::Zero();     ///< of a metre, of a radian; radians on a metre
  Eigen::Matrix3d P_;                                   ///< covariance of scale_
  Eigen::Matrix3d by_scale_ = Eigen::Matrix3d::Zero();  ///< ∂(x, y, yaw)/∂scale since the last known place
  Eigen::Matrix3d by_slip_ = Eigen::Matrix3d::Zero();   ///< covariance since then
  int refused_ = 0;                                     ///< places in a row
};

}  // namespace enfilade::grid_builder
