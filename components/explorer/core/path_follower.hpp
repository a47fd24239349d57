// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "interfaces/geometry/pose2.hpp"
#include "interfaces/model/motion.hpp"

namespace enfilade::explorer {

struct PathFollowerConfig {
  double linear_m_s = 0.45;
  double angular_rad_s = 1.1;
  double deceleration_m_s2 = 0.4;  ///< planned with, towards corners and the goal
  double look_ahead_m = 0.35;      ///< steers at the point this far ahead on the line
  double turn_first_rad = 0.35;    ///< a greater error of heading is turned away before driving
  double goal_tolerance_m = 0.03;
  double yaw_tolerance_rad = 0.035;
  double turn_gain = 3.0;   ///< rad/s per rad
  double creep_m_s = 0.04;  ///< never slower than this while there is way to go
};

/// Leads a differential base along a polyline, turning on the spot where it bends, then to a heading.
class PathFollower {
 public:
  explicit PathFollower(const PathFollowerConfig& config);

  void follow(std::vector<Point2> points, std::optional<double> final_yaw_rad);
  void stop() {
    points_.clear();
    final_yaw_rad_.reset();
  }

  struct Step {
    VelocityCommand velocity;
    bool done = false;
  };
  /// `speed_limit_m_s` is what the surroundings allow.
  Step update(const Pose2& pose, double speed_limit_m_s);

 private:
  Step turn_to(double yaw_rad, const Pose2& pose) const;
  VelocityCommand drive(const Pose2& pose, double limit_m_s);
  bool at_corner(const Pose2& pose) const;
  double remaining_m(const Pose2& pose) const;

  PathFollowerConfig config_;
  std::vector<Point2> points_;
  std::size_t next_ = 0;  ///< index of the corner headed for
  std::optional<double> final_yaw_rad_;
  bool turning_ = true;
};

}  // namespace enfilade::explorer
