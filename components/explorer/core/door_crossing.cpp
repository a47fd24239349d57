// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/door_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace enfilade::explorer {

DoorCrossing::DoorCrossing(const DoorCrossingConfig& config, const SafetyGuardConfig& guard)
    : config_(config), guard_(guard) {
  if (!(config.linear_m_s > 0.0 && config.angular_rad_s > 0.0)) {
    throw std::invalid_argument("DoorCrossing: speeds must be greater than 0");
  }
}

void DoorCrossing::begin(const DoorCorridor& corridor, bool backwards, StampNs now_ns) {
  corridor_ = corridor;
  backwards_ = backwards;
  begun_ns_ = now_ns;
  blocked_since_ns_.reset();
}

CrossingStatus DoorCrossing::update(const Observation& seen, Decision& decision) {
  decision.drive({});
  if (seen.motor->phase != SweepPhase::kParked && seconds(seen.now_ns - begun_ns_) < config_.timeout_s) {
    return CrossingStatus::kUnderWay;
  }
  const Pose2 T_line_base = corridor_.from.inverse() * *seen.T_zone_base;
  const double length_m = (corridor_.to.translation() - corridor_.from.translation()).norm();
  const double rest_m = backwards_ ? T_line_base.x_m : length_m - T_line_base.x_m;
  if (rest_m < 0.01) return CrossingStatus::kDone;
  if (seconds(seen.now_ns - begun_ns_) > config_.timeout_s) return CrossingStatus::kBlocked;

  const VelocityCommand velocity = steer(T_line_base, rest_m);
  const bool blocked = seen.points && !guard_.in_the_way(velocity, seen.points->points).empty();
  if (!blocked) {
    blocked_since_ns_.reset();
    decision.drive(velocity);
    return CrossingStatus::kUnderWay;
  }
  if (!blocked_since_ns_) blocked_since_ns_ = seen.now_ns;
  const bool given_up = seconds(seen.now_ns - *blocked_since_ns_) > config_.blocked_s;
  return given_up ? CrossingStatus::kBlocked : CrossingStatus::kUnderWay;
}

VelocityCommand DoorCrossing::steer(const Pose2& T_line_base, double rest_m) const {
  const double sense = backwards_ ? -1.0 : 1.0;
  const double towards_line = std::clamp(-config_.side_gain_per_m * T_line_base.y_m, -config_.max_heading_rad,
                                         config_.max_heading_rad);
  const double error_rad = wrap_to_pi(sense * towards_line - T_line_base.yaw_rad);
  const double turn =
      std::clamp(config_.turn_gain * error_rad, -config_.angular_rad_s, config_.angular_rad_s);
  if (std::abs(error_rad) > 2.0 * config_.max_heading_rad) return {0.0, turn};
  const double braking_m_s = std::sqrt(2.0 * config_.deceleration_m_s2 * std::max(0.0, rest_m));
  return {sense * std::clamp(braking_m_s, 0.03, config_.linear_m_s), turn};
}

}  // namespace enfilade::explorer
