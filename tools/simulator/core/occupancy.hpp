// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/simulator/core/world.hpp"

namespace enfilade::simulator {

/// A plan of occupied cells as map_server has it; row 0 is the top row of the image.
struct Occupancy {
  int columns = 0, rows = 0;
  std::vector<bool> occupied;  ///< row by row
  std::vector<bool> unknown;   ///< likewise: nobody has been there; empty = none
  double resolution_m = 0.05;
  Pose2 T_world_corner;  ///< lower left corner of the lower left cell

  bool at(int column, int row) const { return occupied[index(column, row)]; }
  bool is_free(int column, int row) const {
    return !at(column, row) && (unknown.empty() || !unknown[index(column, row)]);
  }
  std::size_t index(int column, int row) const { return static_cast<std::size_t>(row) * columns + column; }
};

struct ExtrusionConfig {
  double wall_height_m = 2.5;          ///< > 0
  std::optional<double> ceiling_m;     ///< none: open to the sky
  std::optional<Pose2> T_world_start;  ///< none: where most space is free around
};

/// Every occupied cell becomes a column; columns that make up a rectangle become one solid.
World extrude(const std::string& name, const Occupancy& occupancy, const ExtrusionConfig& config);

}  // namespace enfilade::simulator
