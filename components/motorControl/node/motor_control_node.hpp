// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "components/motorControl/node/motor_control_config.hpp"
#include "components/motorControl/node/motor_driver.hpp"
#include "interfaces/runtime/node.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::motor_control {

/// Owns all actuators: the base and the roll motor of the laser. Control runs on compute(), measurement on
/// every reading.
class MotorControlNode : public Node {
 public:
  MotorControlNode(const NodeContext& context, const MotorControlConfig& config);

  void initialize() override;
  void compute() override;
  void emergency() override;
  void restore() override;
  void shutdown() override;

 private:
  void take(const MotorReading& reading);
  void take(const SweepCommand& command);
  bool encoders_silent();
  void publish_joints(const MotorReading& reading);
  void publish_odometry(StampNs stamp_ns);
  void publish_state();
  void publish_state_if_changed();
  MotorState state() const;

  NodeContext context_;
  MotorControlConfig config_;
  DifferentialDrive drive_;
  WheelOdometry odometry_;
  VelocityLimiter limiter_;
  CommandWatchdog watchdog_;
  SweepController sweep_;
  std::unique_ptr<MotorDriver> driver_;

  Publisher<JointStates> joint_states_;
  Publisher<Odometry> odom_;
  Publisher<TransformList> tf_;
  Publisher<MotorState> motor_state_;

  std::uint32_t odom_boot_ = 0;
  std::optional<StampNs> heard_ns_;   ///< node's clock at the last reading; at first, at the first compute()
  std::optional<StampNs> newest_ns_;  ///< stamp of the last reading
  StampNs next_odometry_ns_ = 0;
  MotorState published_;
};

}  // namespace enfilade::motor_control
