// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "components/explorer/core/projected_grid.hpp"

namespace enfilade::explorer {

/// Cells of a made-up place, 5 cm each. z up to 2.6 m.
class SyntheticRoom {
 public:
  static constexpr double kResolutionM = 0.05;

  /// Free space, floor included.
  SyntheticRoom& free(double x0, double y0, double x1, double y1, double z0 = 0.05, double z1 = 2.6) {
    return fill(x0, y0, x1, y1, z0, z1, CellState::kFree);
  }
  SyntheticRoom& solid(double x0, double y0, double x1, double y1, double z0 = 0.0, double z1 = 2.6) {
    return fill(x0, y0, x1, y1, z0, z1, CellState::kOccupied);
  }
  SyntheticRoom& unexplored(double x0, double y0, double x1, double y1, double z0 = 0.0, double z1 = 2.6) {
    return fill(x0, y0, x1, y1, z0, z1, CellState::kUnexplored);
  }
  /// Free inside x0 … x1, y0 … y1 and walls one cell thick round it.
  SyntheticRoom& room(double x0, double y0, double x1, double y1) {
    const double r = kResolutionM;
    solid(x0 - r, y0 - r, x1 + r, y1 + r);
    return free(x0, y0, x1, y1, 0.0);
  }

  const std::vector<GridCell>& cells() const { return cells_; }
  ProjectedGrid grid() const {
    ProjectedGrid grid{ProjectedGridConfig{}};
    grid.apply(kResolutionM, cells_);
    return grid;
  }

 private:
  SyntheticRoom& fill(double x0, double y0, double x1, double y1, double z0, double z1, CellState state) {
    const auto index = [](double v) { return static_cast<std::int16_t>(std::lround(v / kResolutionM)); };
    for (std::int16_t x = index(x0); x < index(x1); ++x) {
      for (std::int16_t y = index(y0); y < index(y1); ++y) {
        for (std::int16_t z = index(z0); z < index(z1); ++z) cells_.push_back({x, y, z, state});
      }
    }
    return *this;
  }

  std::vector<GridCell> cells_;  // a later cell overrides an earlier one
};

}  // namespace enfilade::explorer
