// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/roll_motor.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "interfaces/geometry/angles.hpp"

namespace enfilade::simulator {

RollMotor::RollMotor(const RollMotorConfig& config) : config_(config) {
  if (config.max_rad_s <= 0 || config.max_rad_s2 <= 0 || config.end_rad <= 0 || config.steps_per_turn < 0)
    throw std::invalid_argument("RollMotorConfig: limits must be greater than 0");
}

void RollMotor::command(double rad_s) {
  command_rad_s_ = std::clamp(rad_s, -config_.max_rad_s, config_.max_rad_s);
}

void RollMotor::step(double dt_s) {
  const double most_rad_s = config_.max_rad_s2 * dt_s;
  const double before_rad_s = speed_rad_s_;
  speed_rad_s_ += std::clamp(command_rad_s_ - speed_rad_s_, -most_rad_s, most_rad_s);
  angle_rad_ += 0.5 * (before_rad_s + speed_rad_s_) * dt_s;
  if (std::abs(angle_rad_) > config_.end_rad) {
    angle_rad_ = std::clamp(angle_rad_, -config_.end_rad, config_.end_rad);
    speed_rad_s_ = 0.0;
  }
}

double RollMotor::read_rad() const {
  if (config_.steps_per_turn == 0) return angle_rad_;
  const double step_rad = 2.0 * kPi / config_.steps_per_turn;
  return step_rad * std::round(angle_rad_ / step_rad);
}

}  // namespace enfilade::simulator
