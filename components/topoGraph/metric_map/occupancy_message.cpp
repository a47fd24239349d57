// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/metric_map/occupancy_message.hpp"

namespace enfilade::topo_graph {

OccupancyMap to_message(const OccupancyGrid& grid, StampNs stamp_ns) {
  constexpr std::array kValues{OccupancyMap::kUnknown, OccupancyMap::kFree,
                               OccupancyMap::kOccupied};  // by CellState
  OccupancyMap map{.stamp_ns = stamp_ns,
                   .frame_id = "map",
                   .resolution_m = static_cast<float>(grid.resolution_m),
                   .columns = static_cast<std::uint32_t>(grid.columns),
                   .rows = static_cast<std::uint32_t>(grid.rows),
                   .T_frame_cells = {.x_m = grid.origin.x(), .y_m = grid.origin.y()}};
  map.cells.reserve(grid.cells.size());
  for (const CellState state : grid.cells) map.cells.push_back(kValues.at(static_cast<std::size_t>(state)));
  return map;
}

}  // namespace enfilade::topo_graph
