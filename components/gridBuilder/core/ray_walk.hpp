// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdlib>
#include <limits>

#include "components/gridBuilder/core/cell_store.hpp"

namespace enfilade::grid_builder {

/// One axis of a walk: where it is, at which share of the ray the next border is met, and how a step shows in
/// a tile.
struct RayAxis {
  int cell, step = 0, borders_left;
  double next_border = std::numeric_limits<double>::infinity(), border_spacing = 0.0;
  std::size_t offset_step = 0;  ///< within a tile; wraps round where it is negative
  int first_in_tile = 0;        ///< remainder of `cell` where a new tile begins

  RayAxis(double from, double to, int from_cell, int to_cell, int offset_bits)
      : cell(from_cell), borders_left(std::abs(to_cell - from_cell)) {
    if (borders_left == 0) return;
    step = to_cell > from_cell ? 1 : -1;
    border_spacing = 1.0 / std::abs(to - from);
    next_border = (step > 0 ? from_cell + 1 - from : from - from_cell) * border_spacing;
    offset_step = static_cast<std::size_t>(step * (1 << offset_bits));
    first_in_tile = step > 0 ? 0 : kTileSide - 1;
  }

  /// Whether this led into another tile.
  bool cross() {
    cell += step;
    next_border = --borders_left > 0 ? next_border + border_spacing : std::numeric_limits<double>::infinity();
    return (cell & (kTileSide - 1)) == first_in_tile;
  }
};

/// Calls `visit(tile, offset, x, y, z)` for every cell of `store` the segment passes through (both ends in
/// units of cells), in order, from the cell of `from` on and without the cell of `to` (Amanatides & Woo
/// 1987). The borders are counted, so rounding can never miss the end. `enter(tile)` is called for each tile
/// entered.
template <class Visit, class Enter>
void walk_ray(CellStore& store, const Eigen::Vector3d& from, const Eigen::Vector3d& to, Visit&& visit,
              Enter&& enter) {
  const CellIndex begin = cell_of(from), end = cell_of(to);
  RayAxis x(from.x(), to.x(), begin.x, end.x, 2 * kTileSideBits),
      y(from.y(), to.y(), begin.y, end.y, kTileSideBits), z(from.z(), to.z(), begin.z, end.z, 0);
  Tile* tile = nullptr;
  std::size_t offset = 0;
  const auto enter_tile = [&] {
    const CellIndex c{x.cell, y.cell, z.cell};
    tile = &store.tile_of(c);
    offset = offset_in_tile(c);
    enter(*tile);
  };
  const auto step = [&](RayAxis& axis) {
    if (axis.cross()) {
      enter_tile();
    } else {
      offset += axis.offset_step;
    }
  };
  int steps = x.borders_left + y.borders_left + z.borders_left;
  if (steps > 0) enter_tile();
  for (; steps > 0; --steps) {
    visit(*tile, offset, x.cell, y.cell, z.cell);
    if (x.next_border < y.next_border && x.next_border < z.next_border) {
      step(x);
    } else if (y.next_border < z.next_border) {
      step(y);
    } else {
      step(z);
    }
  }
}

}  // namespace enfilade::grid_builder
