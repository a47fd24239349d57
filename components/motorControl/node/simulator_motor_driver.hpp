// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/motorControl/node/motor_driver.hpp"
#include "interfaces/bus/bus.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::motor_control {

/// The motors of the simulated robot.
class SimulatorMotorDriver : public MotorDriver {
 public:
  explicit SimulatorMotorDriver(Bus& bus) : bus_(bus) {}

  void start(std::function<void(const MotorReading&)> on_reading) override;
  void send(const MotorOrders& orders) override;

 private:
  Bus& bus_;
  Publisher<SimActuation> actuation_;
};

}  // namespace enfilade::motor_control
