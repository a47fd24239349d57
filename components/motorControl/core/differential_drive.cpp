// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/core/differential_drive.hpp"

#include <cmath>
#include <stdexcept>

namespace enfilade::motor_control {

DifferentialDrive::DifferentialDrive(const DifferentialDriveConfig& config) : config_(config) {
  if (!(config.wheel_radius_m > 0.0) || !(config.track_m > 0.0))
    throw std::invalid_argument("drive: wheel_radius_m and track_m must be greater than 0");
}

Wheels DifferentialDrive::wheel_rates(const VelocityCommand& base) const {
  const double turning_m_s = 0.5 * config_.track_m * base.angular_rad_s;
  return {(base.linear_m_s - turning_m_s) / config_.wheel_radius_m,
          (base.linear_m_s + turning_m_s) / config_.wheel_radius_m};
}

VelocityCommand DifferentialDrive::base_speed(const Wheels& rates_rad_s) const {
  return {0.5 * config_.wheel_radius_m * (rates_rad_s.left + rates_rad_s.right),
          config_.wheel_radius_m * (rates_rad_s.right - rates_rad_s.left) / config_.track_m};
}

Pose2 DifferentialDrive::arc(const Wheels& turned_rad) const {
  const VelocityCommand way = base_speed(turned_rad);
  const double half_rad = 0.5 * way.angular_rad_s;
  // The chord of an arc of length s and angle θ is s · sin(θ/2) / (θ/2) long and points along θ/2.
  const double chord_share =
      std::abs(half_rad) < 1e-6 ? 1.0 - half_rad * half_rad / 6.0 : std::sin(half_rad) / half_rad;
  const double chord_m = way.linear_m_s * chord_share;
  return {chord_m * std::cos(half_rad), chord_m * std::sin(half_rad), way.angular_rad_s};
}

}  // namespace enfilade::motor_control
