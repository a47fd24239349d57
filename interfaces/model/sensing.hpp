// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "interfaces/model/transform.hpp"

namespace enfilade {

/// One line of a 2D range finder (rt/scan). `stamp_ns` is the time of the first beam; beam i is taken
/// `i * time_increment_s` later at `angle_min_rad + i * angle_increment_rad`. Ranges follow REP-117: +inf
/// nothing within reach, -inf too close, NaN no valid measurement.
struct LaserScan {
  StampNs stamp_ns = 0;
  std::string frame_id;
  float angle_min_rad = 0, angle_max_rad = 0, angle_increment_rad = 0;
  float time_increment_s = 0, scan_time_s = 0;
  float range_min_m = 0, range_max_m = 0;
  std::vector<float> ranges_m;
  std::vector<float> intensities;
};

struct Point3f {
  float x_m = 0, y_m = 0, z_m = 0;

  bool operator==(const Point3f&) const = default;
};

/// Points seen from one place (rt/points, rt/points_free): PointCloud2 with fields x, y, z on the wire.
struct PointCloud {
  StampNs stamp_ns = 0;
  std::string frame_id;
  std::vector<Point3f> points;

  bool operator==(const PointCloud&) const = default;
};

/// rt/joint_states. The three vectors are of one length.
struct JointStates {
  StampNs stamp_ns = 0;
  std::vector<std::string> names;
  std::vector<double> positions_rad;
  std::vector<double> velocities_rad_s;

  bool operator==(const JointStates&) const = default;
};

/// The joint that rolls the laser about the base's x axis; 0 = scan plane horizontal.
inline constexpr const char* kRollJoint = "laser_roll_joint";

/// rt/odom: pose of base_link in odom from the wheels alone. It never jumps.
struct Odometry {
  StampNs stamp_ns = 0;
  Transform3 T_odom_base;
  double linear_m_s = 0.0;
  double angular_rad_s = 0.0;

  bool operator==(const Odometry&) const = default;
};

}  // namespace enfilade
