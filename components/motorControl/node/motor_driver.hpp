// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "components/motorControl/core/differential_drive.hpp"
#include "interfaces/model/zone_tag.hpp"

namespace enfilade::motor_control {

/// What the encoders read.
struct MotorReading {
  StampNs stamp_ns = 0;
  Wheels wheels_rad;
  double roll_rad = 0.0;
  double roll_rad_s = 0.0;
};

/// What the motors shall do until told otherwise.
struct MotorOrders {
  Wheels wheels_rad_s;
  double roll_rad_s = 0.0;
};

/// The way to one kind of motor hardware. Readings arrive on the component's executor, at 200 Hz or more.
class MotorDriver {
 public:
  virtual ~MotorDriver() = default;
  virtual void start(std::function<void(const MotorReading&)> on_reading) = 0;
  virtual void send(const MotorOrders& orders) = 0;
};

}  // namespace enfilade::motor_control
