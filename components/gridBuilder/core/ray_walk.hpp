// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "components/gridBuilder/core/cell_index.hpp"

namespace enfilade::grid_builder {

/// One axis of a walk: how many cell borders lie ahead and at which share of the ray the next one is met.
struct RayAxis {
  int step = 0;
  int borders_left = 0;
  double next_border = std::numeric_limits<double>::infinity();
  double border_spacing = 0.0;

  RayAxis(double from, double to, int from_cell, int to_cell) {
    borders_left = std::abs(to_cell - from_cell);
    if (borders_left == 0) return;
    step = to_cell > from_cell ? 1 : -1;
    border_spacing = 1.0 / std::abs(to - from);
    next_border = (step > 0 ? from_cell + 1 - from : from - from_cell) * border_spacing;
  }

  void cross(int& cell) {
    cell += step;
    next_border = --borders_left > 0 ? next_border + border_spacing : std::numeric_limits<double>::infinity();
  }
};

/// Calls `visit(cell)` for every cell the segment passes through (both ends in units of cells), in order,
/// from the cell of `from` on and without the cell of `to` (Amanatides & Woo 1987). The borders are counted,
/// so rounding can never miss the end.
template <class Visit>
void walk_ray(const Eigen::Vector3d& from, const Eigen::Vector3d& to, Visit&& visit) {
  CellIndex cell = cell_of(from);
  const CellIndex end = cell_of(to);
  RayAxis x(from.x(), to.x(), cell.x, end.x), y(from.y(), to.y(), cell.y, end.y),
      z(from.z(), to.z(), cell.z, end.z);
  for (int steps = x.borders_left + y.borders_left + z.borders_left; steps > 0; --steps) {
    visit(cell);
    if (x.next_border < y.next_border && x.next_border < z.next_border) {
      x.cross(cell.x);
    } else if (y.next_border < z.next_border) {
      y.cross(cell.y);
    } else {
      z.cross(cell.z);
    }
  }
}

}  // namespace enfilade::grid_builder
