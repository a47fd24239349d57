// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/topoGraph/metric_map/occupancy_grid.hpp"
#include "interfaces/model/metric_map.hpp"

namespace enfilade::topo_graph {

/// The metric map as it travels on rt/map, in the map frame.
OccupancyMap to_message(const OccupancyGrid& grid, StampNs stamp_ns);

}  // namespace enfilade::topo_graph
