// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/metric_map/map_formats.hpp"

#include <fmt/format.h>

namespace enfilade::topo_graph {

std::vector<std::uint8_t> grey_levels(const OccupancyGrid& grid) {
  constexpr std::uint8_t kLevels[] = {205, 254, 0};  // by CellState
  std::vector<std::uint8_t> levels;
  levels.reserve(grid.cells.size());
  for (int row = grid.rows - 1; row >= 0; --row)
    for (int column = 0; column < grid.columns; ++column)
      levels.push_back(kLevels[static_cast<int>(grid.at(column, row))]);
  return levels;
}

std::string to_pgm(const OccupancyGrid& grid) {
  std::string file =
      fmt::format("P5\n# map, {} m a pixel\n{} {}\n255\n", grid.resolution_m, grid.columns, grid.rows);
  const std::vector<std::uint8_t> levels = grey_levels(grid);
  file.append(levels.begin(), levels.end());
  return file;
}

std::string to_map_server_yaml(const OccupancyGrid& grid, const std::string& image) {
  std::string quoted;
  for (const char c : image) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return fmt::format(
      "image: \"{}\"\nmode: trinary\nresolution: {}\norigin: [{}, {}, 0.0]\nnegate: 0\n"
      "occupied_thresh: 0.65\nfree_thresh: 0.196\n",
      quoted, grid.resolution_m, grid.origin.x(), grid.origin.y());
}

}  // namespace enfilade::topo_graph
