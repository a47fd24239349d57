// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include <Eigen/Core>

#include "interfaces/model/grid.hpp"
#include "interfaces/model/sensing.hpp"

namespace enfilade::grid_builder {

/// Which cell of the zone's grid: floor(coordinate / resolution) per axis, as in GridCell.
struct CellIndex {
  int x = 0, y = 0, z = 0;

  bool operator==(const CellIndex&) const = default;
  /// By x, then y, then z: the order of cells in every message.
  auto operator<=>(const CellIndex&) const = default;
};

/// `p` in units of cells.
inline CellIndex cell_of(const Eigen::Vector3d& p) {
  return {static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())),
          static_cast<int>(std::floor(p.z()))};
}

inline Eigen::Vector3d to_vector(const Point3f& p) { return {p.x_m, p.y_m, p.z_m}; }

inline GridCell to_grid_cell(const CellIndex& c, CellState state) {
  return {static_cast<std::int16_t>(c.x), static_cast<std::int16_t>(c.y), static_cast<std::int16_t>(c.z),
          state};
}

}  // namespace enfilade::grid_builder
