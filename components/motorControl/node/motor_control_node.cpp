// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/node/motor_control_node.hpp"

#include <string>
#include <utility>

#include "components/motorControl/node/odom_boot.hpp"
#include "components/motorControl/node/simulator_motor_driver.hpp"
#include "interfaces/runtime/service.hpp"

namespace enfilade::motor_control {

MotorControlNode::MotorControlNode(const NodeContext& context, const MotorControlConfig& config)
    : context_(context),
      config_(config),
      drive_(config.drive),
      odometry_(config.odometry, drive_),
      limiter_(config.limits),
      watchdog_(config.watchdog),
      sweep_(config.sweep),
      driver_(std::make_unique<SimulatorMotorDriver>(context.bus)) {}

void MotorControlNode::initialize() {
  if (worst_stop_s(config_) > 0.3)
    context_.log.warn("with these limits the base may move for " + std::to_string(worst_stop_s(config_)) +
                      " s after its last command; lower watchdog.stale_after_s or raise limits.brake_*");
  odom_boot_ = odom_boot_of(process_run_id(), context_.clock.now_ns());
  joint_states_ = context_.bus.advertise(topics::kJointStates);
  odom_ = context_.bus.advertise(topics::kOdom);
  tf_ = context_.bus.advertise(topics::kTf);
  motor_state_ = context_.bus.advertise(topics::kMotorState);
  context_.bus.subscribe<VelocityCommand>(
      topics::kCmdVel, [this](const VelocityCommand& c) { watchdog_.take(c, context_.clock.now_ns()); });
  context_.bus.subscribe<SweepCommand>(topics::kSweepCommand, [this](const SweepCommand& c) { take(c); });
  driver_->start([this](const MotorReading& reading) { take(reading); });
  context_.executor.every(from_seconds(1.0 / config_.state_rate_hz), [this] { publish_state(); });
}

void MotorControlNode::compute() {
  if (encoders_silent()) {
    emergency();
    context_.lifecycle.go_to_emergency("no encoder reading for " + std::to_string(config_.encoder_silence_s) +
                                       " s: the motors are stopped");
    return;
  }
  const double dt_s = config_.period.compute_s;
  const auto command = watchdog_.command(context_.clock.now_ns());
  const VelocityCommand speed =
      limiter_.step(command.value_or(VelocityCommand{}), dt_s, command ? Slowing::kSmooth : Slowing::kBrake);
  driver_->send({.wheels_rad_s = drive_.wheel_rates(speed), .roll_rad_s = sweep_.speed(dt_s)});
  publish_state_if_changed();
}

void MotorControlNode::emergency() {
  limiter_.reset();
  watchdog_.forget();
  driver_->send({});
  if (!encoders_silent()) context_.lifecycle.go_to_restore();
}

void MotorControlNode::restore() { sweep_.restart(); }

void MotorControlNode::shutdown() { driver_->send({}); }

bool MotorControlNode::encoders_silent() {
  const StampNs now_ns = context_.clock.now_ns();
  if (!heard_ns_) heard_ns_ = now_ns;
  return seconds(now_ns - *heard_ns_) > config_.encoder_silence_s;
}

void MotorControlNode::take(const MotorReading& reading) {
  if (newest_ns_ && reading.stamp_ns <= *newest_ns_) return;
  newest_ns_ = reading.stamp_ns;
  heard_ns_ = context_.clock.now_ns();
  odometry_.update(reading.stamp_ns, reading.wheels_rad);
  sweep_.observe(reading.stamp_ns, reading.roll_rad);
  publish_joints(reading);
  if (reading.stamp_ns >= next_odometry_ns_) publish_odometry(reading.stamp_ns);
  publish_state_if_changed();
}

void MotorControlNode::take(const SweepCommand& command) {
  if (sweep_.command(command) == SweepVerdict::kInvalid)
    context_.log.warn("sweep command " + std::to_string(command.sweep_id) +
                      " ignored: its range is empty, or its range or speed is no usable number");
  publish_state_if_changed();
}

void MotorControlNode::publish_joints(const MotorReading& reading) {
  const VelocityCommand speed = odometry_.speed();
  const Wheels rates_rad_s = drive_.wheel_rates(speed);
  joint_states_.publish(
      {.stamp_ns = reading.stamp_ns,
       .names = {kRollJoint, "left_wheel_joint", "right_wheel_joint"},
       .positions_rad = {reading.roll_rad, reading.wheels_rad.left, reading.wheels_rad.right},
       .velocities_rad_s = {reading.roll_rad_s, rates_rad_s.left, rates_rad_s.right}});
}

void MotorControlNode::publish_odometry(StampNs stamp_ns) {
  const StampNs period_ns = from_seconds(1.0 / config_.odometry_rate_hz);
  next_odometry_ns_ = (stamp_ns / period_ns + 1) * period_ns;
  const Transform3 T_odom_base = to_transform3(odometry_.T_odom_base());
  const VelocityCommand speed = odometry_.speed();
  odom_.publish({.stamp_ns = stamp_ns,
                 .T_odom_base = T_odom_base,
                 .linear_m_s = speed.linear_m_s,
                 .angular_rad_s = speed.angular_rad_s});
  tf_.publish({.transforms = {{stamp_ns, "odom", "base_link", T_odom_base}}});
}

MotorState MotorControlNode::state() const {
  const VelocityCommand& driven = limiter_.speed();
  return {.stamp_ns = newest_ns_.value_or(0),
          .odom_boot = odom_boot_,
          .sweep_id = sweep_.sweep_id(),
          .phase = sweep_.phase(),
          .sweep_start_ns = sweep_.sweep_start_ns(),
          .sweep_end_ns = sweep_.sweep_end_ns(),
          .base_moving = odometry_.moving() || driven != VelocityCommand{}};
}

void MotorControlNode::publish_state() {
  published_ = state();
  motor_state_.publish(published_);
}

void MotorControlNode::publish_state_if_changed() {
  MotorState now = state();
  now.stamp_ns = published_.stamp_ns;
  if (now != published_) publish_state();
}

}  // namespace enfilade::motor_control
