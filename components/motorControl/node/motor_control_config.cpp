// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/node/motor_control_config.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::motor_control {
namespace {

void bind(ConfigBinder& c, DifferentialDriveConfig& drive) {
  c.number("wheel_radius_m", drive.wheel_radius_m, 0.01, 1.0);
  c.number("track_m", drive.track_m, 0.05, 2.0);
}

void bind(ConfigBinder& c, WheelOdometryConfig& odometry) {
  c.number("speed_window_s", odometry.speed_window_s, 0.005, 0.5);
  c.number("still_linear_m_s", odometry.still_linear_m_s, 0.0, 0.1);
  c.number("still_angular_rad_s", odometry.still_angular_rad_s, 0.0, 0.1);
  c.number("settle_s", odometry.settle_s, 0.0, 5.0);
}

void bind(ConfigBinder& c, VelocityLimiterConfig& limits) {
  c.number("max_linear_m_s", limits.max_linear_m_s, 0.01, 5.0);
  c.number("max_angular_rad_s", limits.max_angular_rad_s, 0.01, 10.0);
  c.number("acceleration_m_s2", limits.acceleration_m_s2, 0.01, 50.0);
  c.number("acceleration_rad_s2", limits.acceleration_rad_s2, 0.01, 100.0);
  c.number("deceleration_m_s2", limits.deceleration_m_s2, 0.01, 50.0);
  c.number("deceleration_rad_s2", limits.deceleration_rad_s2, 0.01, 100.0);
  c.number("brake_m_s2", limits.brake_m_s2, 0.01, 100.0);
  c.number("brake_rad_s2", limits.brake_rad_s2, 0.01, 200.0);
}

void bind(ConfigBinder& c, SweepControllerConfig& sweep) {
  c.number("lowest_rad", sweep.lowest_rad, -3.2, 3.2);
  c.number("highest_rad", sweep.highest_rad, -3.2, 3.2);
  c.number("overrun_rad", sweep.overrun_rad, 0.03, 1.0);
  c.number("max_speed_rad_s", sweep.max_speed_rad_s, 0.01, 20.0);
  c.number("acceleration_rad_s2", sweep.acceleration_rad_s2, 0.1, 200.0);
  c.number("settle_s", sweep.settle_s, 0.01, 1.0);
  c.number("tolerance_rad", sweep.tolerance_rad, 0.001, 0.1);
}

}  // namespace

void bind(ConfigBinder& c, MotorControlConfig& config) {
  c.group("period", [&](ConfigBinder& g) { bind(g, config.period); });
  c.choice("driver", config.driver, {{"simulator", DriverKind::kSimulator}});
  c.number("encoder_silence_s", config.encoder_silence_s, 0.02, 10.0);
  c.number("odometry_rate_hz", config.odometry_rate_hz, 1.0, 1000.0);
  c.number("state_rate_hz", config.state_rate_hz, 0.1, 100.0);
  c.group("drive", [&](ConfigBinder& g) { bind(g, config.drive); });
  c.group("odometry", [&](ConfigBinder& g) { bind(g, config.odometry); });
  c.group("limits", [&](ConfigBinder& g) { bind(g, config.limits); });
  c.group("watchdog",
          [&](ConfigBinder& g) { g.number("stale_after_s", config.watchdog.stale_after_s, 0.02, 10.0); });
  c.group("sweep", [&](ConfigBinder& g) { bind(g, config.sweep); });
}

double worst_stop_s(const MotorControlConfig& config) {
  const VelocityLimiterConfig& limits = config.limits;
  const double brake_s =
      std::max(limits.max_linear_m_s / limits.brake_m_s2, limits.max_angular_rad_s / limits.brake_rad_s2);
  // Seen stale up to one period late; the last braking step starts after all others have lasted a whole
  // period each.
  const double steps = std::ceil(brake_s / config.period.compute_s - 1e-9);
  return config.watchdog.stale_after_s + steps * config.period.compute_s;
}

}  // namespace enfilade::motor_control
