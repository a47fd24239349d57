// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/motorControl/core/command_watchdog.hpp"
#include "components/motorControl/core/differential_drive.hpp"
#include "components/motorControl/core/sweep_controller.hpp"
#include "components/motorControl/core/velocity_limiter.hpp"
#include "components/motorControl/core/wheel_odometry.hpp"
#include "interfaces/runtime/config.hpp"

namespace enfilade::motor_control {

enum class DriverKind { kSimulator };

struct MotorControlConfig {
  PeriodConfig period{.compute_s = 0.02,
                      .emergency_s = 0.1};  ///< compute_s is the control period of base and sweep
  DriverKind driver = DriverKind::kSimulator;
  double encoder_silence_s = 0.5;  ///< no reading for longer than this is an emergency
  double odometry_rate_hz = 50.0;
  double state_rate_hz = 2.0;
  DifferentialDriveConfig drive;
  WheelOdometryConfig odometry;
  VelocityLimiterConfig limits;
  CommandWatchdogConfig watchdog;
  SweepControllerConfig sweep;
};

void bind(ConfigBinder& c, MotorControlConfig& config);

/// How long after its last command the base can still be moving, by these settings.
double worst_stop_s(const MotorControlConfig& config);

}  // namespace enfilade::motor_control
