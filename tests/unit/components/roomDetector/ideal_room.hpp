// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "interfaces/model/grid.hpp"

namespace enfilade::room_detector::test {

/// The grid of a room 4.0 × 3.0 m, axis-parallel, walls of one cell just outside x = ±2 and y = ±1.5, up
/// to 2.5 m, and 0.5 m of free ground all round. `wall_state` says what a wall cell at (x, y, z) holds where
/// it is not to be occupied.
inline GridChange ideal_room(const std::function<CellState(double x, double y, double z)>& wall_state,
                             double r = 0.05) {
  GridChange change{.sequence = 1, .resolution_m = r};
  const auto cells = [r](double metres) {
    return static_cast<std::int16_t>(metres / r + (metres < 0 ? -0.5 : 0.5));
  };
  const std::int16_t w = cells(2.0), h = cells(1.5), margin = cells(0.5);
  for (std::int16_t x = static_cast<std::int16_t>(-w - margin); x < w + margin; ++x) {
    for (std::int16_t y = static_cast<std::int16_t>(-h - margin); y < h + margin; ++y) {
      const bool in_x = x >= -w && x < w, in_y = y >= -h && y < h;
      const bool is_wall =
          (x == -w - 1 || x == w) ? (y >= -h - 1 && y <= h) : (y == -h - 1 || y == h) && in_x;
      for (std::int16_t z = 0; z < cells(2.5); ++z) {
        const auto state =
            is_wall ? wall_state((x + 0.5) * r, (y + 0.5) * r, (z + 0.5) * r) : CellState::kFree;
        const bool is_hidden = !is_wall && !(in_x && in_y);
        change.cells.push_back({x, y, z, is_hidden ? CellState::kFree : state});
      }
    }
  }
  return change;
}

}  // namespace enfilade::room_detector::test
