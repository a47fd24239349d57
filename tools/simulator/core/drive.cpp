// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/drive.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace enfilade::simulator {

Pose2 DriveStep::from(const Pose2& T_world_base) const {
  const double half_rad = 0.5 * turn_rad;
  // The chord of the arc: it points half the turn ahead, and is shorter than the arc by sinc(turn / 2).
  const double chord_m = std::abs(half_rad) < 1e-9 ? forward_m : forward_m * std::sin(half_rad) / half_rad;
  return T_world_base * Pose2{chord_m * std::cos(half_rad), chord_m * std::sin(half_rad), turn_rad};
}

Drive::Drive(const DriveConfig& config) : config_(config) {
  if (config.wheel_radius_m <= 0 || config.track_m <= 0 || config.max_wheel_rad_s <= 0 ||
      config.max_wheel_rad_s2 <= 0 || config.slip_m_per_sqrt_m < 0 || config.encoder_ticks_per_turn < 0)
    throw std::invalid_argument("DriveConfig: sizes and limits must be greater than 0");
}

void Drive::command(double left_rad_s, double right_rad_s) {
  left_.command_rad_s = std::clamp(left_rad_s, -config_.max_wheel_rad_s, config_.max_wheel_rad_s);
  right_.command_rad_s = std::clamp(right_rad_s, -config_.max_wheel_rad_s, config_.max_wheel_rad_s);
}

double Drive::turn(Wheel& wheel, double radius_m, double dt_s, Random& random) const {
  const double most_rad_s = config_.max_wheel_rad_s2 * dt_s;
  const double before_rad_s = wheel.speed_rad_s;
  wheel.speed_rad_s += std::clamp(wheel.command_rad_s - wheel.speed_rad_s, -most_rad_s, most_rad_s);
  const double turned_rad = 0.5 * (before_rad_s + wheel.speed_rad_s) * dt_s;
  wheel.angle_rad += turned_rad;
  if (turned_rad == 0.0) return 0.0;
  const double way_m = turned_rad * radius_m;
  return way_m + random.gauss(config_.slip_m_per_sqrt_m * std::sqrt(std::abs(way_m)));
}

DriveStep Drive::step(double dt_s, Random& random) {
  const double left_m = turn(left_, config_.wheel_radius_m * config_.left_radius_scale, dt_s, random);
  const double right_m = turn(right_, config_.wheel_radius_m * config_.right_radius_scale, dt_s, random);
  return {0.5 * (left_m + right_m), (right_m - left_m) / (config_.track_m * config_.track_scale)};
}

double Drive::quantised(double angle_rad) const {
  if (config_.encoder_ticks_per_turn == 0) return angle_rad;
  const double tick_rad = 2.0 * kPi / config_.encoder_ticks_per_turn;
  return tick_rad * std::floor(angle_rad / tick_rad);
}

}  // namespace enfilade::simulator
