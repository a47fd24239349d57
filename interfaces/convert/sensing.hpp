// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <enfilade_idl/nav_msgs.h>
#include <enfilade_idl/sensor_msgs.h>
#include <enfilade_idl/tf2_msgs.h>

#include "interfaces/convert/common.hpp"
#include "interfaces/model/sensing.hpp"

namespace enfilade::wire {

namespace ros_sensor = ::sensor_msgs::msg::dds_;
namespace ros_geometry = ::geometry_msgs::msg::dds_;
namespace ros_nav = ::nav_msgs::msg::dds_;
namespace ros_tf2 = ::tf2_msgs::msg::dds_;

ros_sensor::LaserScan_ to_wire(const LaserScan& scan);
LaserScan from_wire(const ros_sensor::LaserScan_& scan);

/// Fields x, y, z of FLOAT32, 12 bytes a point, one row.
ros_sensor::PointCloud2_ to_wire(const PointCloud& cloud);
/// Reads x, y, z of FLOAT32 at any offset, organised clouds row by row; refuses a cloud whose sizes
/// contradict each other.
PointCloud from_wire(const ros_sensor::PointCloud2_& cloud);

/// Velocities may be absent on the wire (then they are 0); efforts are not read.
ros_sensor::JointState_ to_wire(const JointStates& joints);
JointStates from_wire(const ros_sensor::JointState_& joints);

/// Frames are odom and base_link; covariances are 0, which ROS 2 reads as unknown. Only the planar speeds are
/// read.
ros_nav::Odometry_ to_wire(const Odometry& odometry);
Odometry from_wire(const ros_nav::Odometry_& odometry);

ros_tf2::TFMessage_ to_wire(const TransformList& list);
TransformList from_wire(const ros_tf2::TFMessage_& list);

}  // namespace enfilade::wire
