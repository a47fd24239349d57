// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/motion.hpp"

namespace enfilade::wire {

ros_graph::Clock_ to_wire(const ClockTick& tick) {
  ros_graph::Clock_ out;
  out.clock(to_wire(tick.now_ns));
  return out;
}

ClockTick from_wire(const ros_graph::Clock_& tick) { return {from_wire(tick.clock())}; }

own::SimCredit_ to_wire(const SimCredit& credit) {
  own::SimCredit_ out;
  out.component_name(credit.component_name);
  out.done_ns(credit.done_ns);
  return out;
}

SimCredit from_wire(const own::SimCredit_& credit) {
  return {checked(credit.component_name()), credit.done_ns()};
}

own::SimActuation_ to_wire(const SimActuation& actuation) {
  own::SimActuation_ out;
  out.left_wheel_rad_s(actuation.left_wheel_rad_s);
  out.right_wheel_rad_s(actuation.right_wheel_rad_s);
  out.roll_rad_s(actuation.roll_rad_s);
  return out;
}

SimActuation from_wire(const own::SimActuation_& actuation) {
  return {actuation.left_wheel_rad_s(), actuation.right_wheel_rad_s(), actuation.roll_rad_s()};
}

own::SimEncoders_ to_wire(const SimEncoders& encoders) {
  own::SimEncoders_ out;
  out.stamp_ns(encoders.stamp_ns);
  out.left_wheel_rad(encoders.left_wheel_rad);
  out.right_wheel_rad(encoders.right_wheel_rad);
  out.roll_rad(encoders.roll_rad);
  out.roll_rad_s(encoders.roll_rad_s);
  return out;
}

SimEncoders from_wire(const own::SimEncoders_& encoders) {
  return {encoders.stamp_ns(), encoders.left_wheel_rad(), encoders.right_wheel_rad(), encoders.roll_rad(),
          encoders.roll_rad_s()};
}

own::GroundTruth_ to_wire(const GroundTruth& truth) {
  own::GroundTruth_ out;
  out.stamp_ns(truth.stamp_ns);
  out.pose_world_base(to_wire(truth.T_world_base));
  out.collisions(truth.collisions);
  out.path_length_m(truth.path_length_m);
  return out;
}

GroundTruth from_wire(const own::GroundTruth_& truth) {
  return {truth.stamp_ns(), from_wire(truth.pose_world_base()), truth.collisions(), truth.path_length_m()};
}

}  // namespace enfilade::wire
