// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/path_follower.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace enfilade::explorer {

PathFollower::PathFollower(const PathFollowerConfig& config) : config_(config) {
  if (!(config.linear_m_s > 0.0 && config.angular_rad_s > 0.0 && config.look_ahead_m > 0.0)) {
    throw std::invalid_argument("PathFollower: speeds and look_ahead_m must be greater than 0");
  }
}

void PathFollower::follow(std::vector<Point2> points, std::optional<double> final_yaw_rad) {
  points_ = std::move(points);
  final_yaw_rad_ = final_yaw_rad;
  next_ = 1;
  turning_ = true;
}

PathFollower::Step PathFollower::update(const Pose2& pose, double speed_limit_m_s) {
  while (next_ < points_.size() && at_corner(pose)) {
    ++next_;
    turning_ = true;
  }
  if (next_ < points_.size()) return {drive(pose, speed_limit_m_s), false};
  if (final_yaw_rad_) return turn_to(*final_yaw_rad_, pose);
  return {{}, true};
}

PathFollower::Step PathFollower::turn_to(double yaw_rad, const Pose2& pose) const {
  const double error_rad = wrap_to_pi(yaw_rad - pose.yaw_rad);
  if (std::abs(error_rad) < config_.yaw_tolerance_rad) return {{}, true};
  const double speed =
      std::clamp(config_.turn_gain * error_rad, -config_.angular_rad_s, config_.angular_rad_s);
  return {{0.0, speed}, false};
}

/// Way to go along the present leg; negative beyond its end.
double PathFollower::remaining_m(const Pose2& pose) const {
  const Point2 leg = points_[next_] - points_[next_ - 1];
  const Point2 rest = points_[next_] - pose.translation();
  return leg.norm() > 1e-6 ? rest.dot(leg.normalized()) : 0.0;
}

bool PathFollower::at_corner(const Pose2& pose) const {
  const double rest_m = remaining_m(pose);
  const bool near = (points_[next_] - pose.translation()).norm() < config_.goal_tolerance_m;
  return rest_m < 0.3 * config_.goal_tolerance_m || (near && rest_m < 0.5 * config_.goal_tolerance_m);
}

VelocityCommand PathFollower::drive(const Pose2& pose, double limit_m_s) {
  const Point2 along = (points_[next_] - points_[next_ - 1]).normalized();
  const double rest_m = remaining_m(pose);
  const Point2 on_line = points_[next_] - along * rest_m;
  const Point2 aim = on_line + along * config_.look_ahead_m;
  const Point2 way = aim - pose.translation();
  const double error_rad = wrap_to_pi(std::atan2(way.y(), way.x()) - pose.yaw_rad);
  if (std::abs(error_rad) > config_.turn_first_rad) turning_ = true;
  if (turning_ && std::abs(error_rad) < 2.0 * config_.yaw_tolerance_rad) turning_ = false;
  const double turn =
      std::clamp(config_.turn_gain * error_rad, -config_.angular_rad_s, config_.angular_rad_s);
  if (turning_) return {0.0, turn};
  const double braking_m_s = std::sqrt(2.0 * config_.deceleration_m_s2 * std::max(0.0, rest_m));
  const double slowed_m_s = config_.linear_m_s * std::cos(std::min(2.0 * std::abs(error_rad), 1.4));
  const double speed = std::min({config_.linear_m_s, limit_m_s, braking_m_s, slowed_m_s});
  return {std::max(speed, std::min(config_.creep_m_s, limit_m_s)), turn};
}

}  // namespace enfilade::explorer
