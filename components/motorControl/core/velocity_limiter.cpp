// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/core/velocity_limiter.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace enfilade::motor_control {
namespace {

double approach(double speed, double target, double faster_by, double slower_by) {
  const bool speeds_up = speed * target >= 0.0 && std::abs(target) > std::abs(speed);
  const double change = speeds_up ? faster_by : slower_by;
  return std::clamp(target, speed - change, speed + change);
}

VelocityCommand within(const VelocityCommand& target, const VelocityLimiterConfig& limits) {
  if (!std::isfinite(target.linear_m_s) || !std::isfinite(target.angular_rad_s)) return {};
  const double excess = std::max({1.0, std::abs(target.linear_m_s) / limits.max_linear_m_s,
                                  std::abs(target.angular_rad_s) / limits.max_angular_rad_s});
  return {target.linear_m_s / excess, target.angular_rad_s / excess};
}

}  // namespace

VelocityLimiter::VelocityLimiter(const VelocityLimiterConfig& config) : config_(config) {
  const double lowest = std::min({config.max_linear_m_s, config.max_angular_rad_s, config.acceleration_m_s2,
                                  config.acceleration_rad_s2, config.deceleration_m_s2,
                                  config.deceleration_rad_s2, config.brake_m_s2, config.brake_rad_s2});
  if (!(lowest > 0.0)) throw std::invalid_argument("limits: every limit must be greater than 0");
}

VelocityCommand VelocityLimiter::step(const VelocityCommand& target, double dt_s, Slowing slowing) {
  const VelocityCommand allowed = within(target, config_);
  const bool brake = slowing == Slowing::kBrake;
  speed_.linear_m_s = approach(speed_.linear_m_s, allowed.linear_m_s, config_.acceleration_m_s2 * dt_s,
                               (brake ? config_.brake_m_s2 : config_.deceleration_m_s2) * dt_s);
  speed_.angular_rad_s =
      approach(speed_.angular_rad_s, allowed.angular_rad_s, config_.acceleration_rad_s2 * dt_s,
               (brake ? config_.brake_rad_s2 : config_.deceleration_rad_s2) * dt_s);
  return speed_;
}

}  // namespace enfilade::motor_control
