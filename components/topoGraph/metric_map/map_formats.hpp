// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/topoGraph/metric_map/occupancy_grid.hpp"

/// The metric map as files that other programs read.
namespace enfilade::topo_graph {

/// Grey levels of map_server (mode trinary), highest row first: 0 occupied, 254 free, 205 unexplored.
std::vector<std::uint8_t> grey_levels(const OccupancyGrid& grid);
/// Binary PGM.
std::string to_pgm(const OccupancyGrid& grid);
/// The YAML beside an image, for map_server and Nav2.
std::string to_map_server_yaml(const OccupancyGrid& grid, const std::string& image);

/// OctoMap's .bt: walls extruded from the floor to `ceiling_m`, space between free, doors free up to their
/// lintel. Written here rather than by OctoMap: whole blocks of one state become one leaf without visiting
/// their cells. Throws std::invalid_argument where the tree's 2^16 cells a side do not reach.
std::string to_octomap(const OccupancyGrid& grid, double ceiling_m = 2.5);

}  // namespace enfilade::topo_graph
