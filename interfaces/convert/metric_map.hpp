// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <enfilade_idl/nav_msgs.h>
#include <enfilade_idl/octomap_msgs.h>

#include "interfaces/convert/common.hpp"
#include "interfaces/model/metric_map.hpp"

namespace enfilade::wire {

namespace ros_nav = ::nav_msgs::msg::dds_;
namespace ros_octomap = ::octomap_msgs::msg::dds_;

/// The time of loading is the stamp of the message.
ros_nav::OccupancyGrid_ to_wire(const OccupancyMap& map);
/// Refuses a map with more or fewer cells than its sizes tell, or without a resolution.
OccupancyMap from_wire(const ros_nav::OccupancyGrid_& grid);

ros_octomap::Octomap_ to_wire(const OctreeMap& map);
/// Refuses all but binary OcTrees.
OctreeMap from_wire(const ros_octomap::Octomap_& octomap);

}  // namespace enfilade::wire
