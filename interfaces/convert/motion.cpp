// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/motion.hpp"

namespace enfilade::wire {

ros_geometry::Twist_ to_wire(const VelocityCommand& command) {
  ros_geometry::Twist_ out;
  out.linear().x(command.linear_m_s);
  out.angular().z(command.angular_rad_s);
  return out;
}

VelocityCommand from_wire(const ros_geometry::Twist_& twist) {
  return {twist.linear().x(), twist.angular().z()};
}

own::SweepCommand_ to_wire(const SweepCommand& command) {
  own::SweepCommand_ out;
  out.sweep_id(command.sweep_id);
  out.action(enum_to_wire(command.action));
  out.from_rad(command.from_rad);
  out.to_rad(command.to_rad);
  out.speed_rad_s(command.speed_rad_s);
  return out;
}

SweepCommand from_wire(const own::SweepCommand_& command) {
  return {command.sweep_id(),
          enum_from_wire(command.action(), SweepAction::kPark, "the action of a sweep command"),
          command.from_rad(), command.to_rad(), command.speed_rad_s()};
}

own::MotorState_ to_wire(const MotorState& state) {
  own::MotorState_ out;
  out.stamp_ns(state.stamp_ns);
  out.odom_boot(state.odom_boot);
  out.sweep_id(state.sweep_id);
  out.phase(enum_to_wire(state.phase));
  out.sweep_start_ns(state.sweep_start_ns);
  out.sweep_end_ns(state.sweep_end_ns);
  out.base_moving(state.base_moving);
  return out;
}

MotorState from_wire(const own::MotorState_& state) {
  return {.stamp_ns = state.stamp_ns(),
          .odom_boot = state.odom_boot(),
          .sweep_id = state.sweep_id(),
          .phase = enum_from_wire(state.phase(), SweepPhase::kDone, "the phase of a motor state"),
          .sweep_start_ns = state.sweep_start_ns(),
          .sweep_end_ns = state.sweep_end_ns(),
          .base_moving = state.base_moving()};
}

own::Heartbeat_ to_wire(const Heartbeat& heartbeat) {
  own::Heartbeat_ out;
  out.component_name(heartbeat.component_name);
  out.host(heartbeat.host);
  out.pid(heartbeat.pid);
  out.wall_ns(heartbeat.wall_ns);
  out.state(enum_to_wire(heartbeat.state));
  out.cycles(heartbeat.cycles);
  out.detail(heartbeat.detail);
  return out;
}

Heartbeat from_wire(const own::Heartbeat_& heartbeat) {
  return {.component_name = checked(heartbeat.component_name()),
          .host = checked(heartbeat.host()),
          .pid = heartbeat.pid(),
          .wall_ns = heartbeat.wall_ns(),
          .state = enum_from_wire(heartbeat.state(), LifecycleState::kStopping, "the state of a heartbeat"),
          .cycles = heartbeat.cycles(),
          .detail = checked(heartbeat.detail())};
}

ros_log::Log_ to_wire(const LogLine& line) {
  ros_log::Log_ out;
  out.stamp(to_wire(line.stamp_ns));
  out.level(line.level);
  out.name(line.component_name);
  out.msg(line.text);
  return out;
}

LogLine from_wire(const ros_log::Log_& line) {
  return {from_wire(line.stamp()), line.level(), checked(line.name()), checked(line.msg())};
}

}  // namespace enfilade::wire
