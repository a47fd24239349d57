// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "interfaces/model/topological_map.hpp"

namespace enfilade::topo_graph {

struct MapCheckConfig {
  double overlap_m = 0.15;  ///< by which rooms of one floor may reach into each other
  double min_side_m = 0.5, max_side_m = 300.0;
  double max_along_m = 0.4;       ///< between the faces of a door, along the wall
  double max_thickness_m = 1.0;   ///< between them, across it
  double max_angle_rad = 0.2618;  ///< 15°: by which the walls of a door may miss being parallel
  double beyond_m = 0.4;          ///< how far behind an unresolved door a room is looked for
};

/// What cannot be true of a building: rooms that overlap or have impossible sizes, doors whose faces do not
/// meet, doors that a room behind them lacks, gaps over one another, rooms that no passage reaches. One
/// sentence each, by room, then by door; empty = nothing is wrong.
std::vector<std::string> check_map(const TopologicalMap& map, const MapCheckConfig& config = {});

}  // namespace enfilade::topo_graph
