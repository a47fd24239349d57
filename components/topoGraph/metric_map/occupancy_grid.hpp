// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "interfaces/model/grid.hpp"
#include "interfaces/model/topological_map.hpp"

namespace enfilade::topo_graph {

struct MetricMapConfig {
  double resolution_m = 0.05;
  double wall_m = 0.1;        ///< drawn thickness of a wall outside a room, at least √2 cells
  double margin_m = 0.2;      ///< of unexplored space around everything
  double lintel_m = 2.0;      ///< of doors whose height is not known
  std::vector<RoomId> rooms;  ///< empty = all
};

/// A door's cell between two rooms (or outside one): free below the lintel.
struct DoorCell {
  std::size_t cell = 0;
  double lintel_m = 0.0;

  bool operator==(const DoorCell&) const = default;
};

/// The map frame as cells: (column, row) covers origin + resolution · [column, column + 1) × [row, row + 1).
struct OccupancyGrid {
  double resolution_m = 0.0;
  Point2 origin = Point2::Zero();  ///< a multiple of the resolution, so that grids of one resolution agree
  int columns = 0, rows = 0;
  std::vector<CellState> cells;  ///< row by row, the lowest first
  std::vector<DoorCell> doors;   ///< by cell; those are free in `cells`

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  CellState at(int column, int row) const { return cells[index(column, row)]; }
  /// Unexplored where `p` lies outside.
  CellState at(const Point2& p) const;
};

/// The metric map that the graph implies: rooms free, walls around them occupied, doors open. At any
/// resolution one cannot get from one room into another but through a door, and a door is not closed by the
/// rounding to cells; blocked and closed doors are wall. Throws std::invalid_argument: no such room, no room
/// at all, a resolution outside 0.005 … 5 m, or more than 2^28 cells.
OccupancyGrid draw_metric_map(const TopologicalMap& map, const MetricMapConfig& config);

/// The resolution of `config`, doubled until the map has at most `most_cells`, or cells of 5 m. Throws
/// std::invalid_argument where there is no room.
double resolution_within(const TopologicalMap& map, MetricMapConfig config, std::size_t most_cells);

}  // namespace enfilade::topo_graph
