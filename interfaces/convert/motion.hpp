// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <enfilade_idl/enfilade_motion.h>
#include <enfilade_idl/geometry_msgs.h>
#include <enfilade_idl/rcl_interfaces.h>
#include <enfilade_idl/rosgraph_msgs.h>

#include "interfaces/convert/common.hpp"
#include "interfaces/model/health.hpp"
#include "interfaces/model/motion.hpp"
#include "interfaces/model/simulation.hpp"

namespace enfilade::wire {

namespace ros_geometry = ::geometry_msgs::msg::dds_;
namespace ros_graph = ::rosgraph_msgs::msg::dds_;
namespace ros_log = ::rcl_interfaces::msg::dds_;

/// Only linear.x and angular.z are read.
ros_geometry::Twist_ to_wire(const VelocityCommand& command);
VelocityCommand from_wire(const ros_geometry::Twist_& twist);

own::SweepCommand_ to_wire(const SweepCommand& command);
SweepCommand from_wire(const own::SweepCommand_& command);
own::MotorState_ to_wire(const MotorState& state);
MotorState from_wire(const own::MotorState_& state);

own::Heartbeat_ to_wire(const Heartbeat& heartbeat);
Heartbeat from_wire(const own::Heartbeat_& heartbeat);
/// File, function and line stay empty.
ros_log::Log_ to_wire(const LogLine& line);
LogLine from_wire(const ros_log::Log_& line);

ros_graph::Clock_ to_wire(const ClockTick& tick);
ClockTick from_wire(const ros_graph::Clock_& tick);
own::SimCredit_ to_wire(const SimCredit& credit);
SimCredit from_wire(const own::SimCredit_& credit);
own::SimActuation_ to_wire(const SimActuation& actuation);
SimActuation from_wire(const own::SimActuation_& actuation);
own::SimEncoders_ to_wire(const SimEncoders& encoders);
SimEncoders from_wire(const own::SimEncoders_& encoders);
own::GroundTruth_ to_wire(const GroundTruth& truth);
GroundTruth from_wire(const own::GroundTruth_& truth);

}  // namespace enfilade::wire
