// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/node/simulator_motor_driver.hpp"

#include <utility>

namespace enfilade::motor_control {

void SimulatorMotorDriver::start(std::function<void(const MotorReading&)> on_reading) {
  actuation_ = bus_.advertise(topics::kSimActuation);
  bus_.subscribe<SimEncoders>(topics::kSimEncoders,
                              [on_reading = std::move(on_reading)](const SimEncoders& e) {
                                on_reading({.stamp_ns = e.stamp_ns,
                                            .wheels_rad = {e.left_wheel_rad, e.right_wheel_rad},
                                            .roll_rad = e.roll_rad,
                                            .roll_rad_s = e.roll_rad_s});
                              });
}

void SimulatorMotorDriver::send(const MotorOrders& orders) {
  actuation_.publish({.left_wheel_rad_s = orders.wheels_rad_s.left,
                      .right_wheel_rad_s = orders.wheels_rad_s.right,
                      .roll_rad_s = orders.roll_rad_s});
}

}  // namespace enfilade::motor_control
