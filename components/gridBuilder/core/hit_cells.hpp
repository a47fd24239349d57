// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "components/gridBuilder/core/cell_index.hpp"

namespace enfilade::grid_builder {

/// The returns of one scan line that fell into one cell.
struct HitCell {
  CellIndex cell;
  CellHit hit;
};

/// A return and the cell it lies in.
struct CellReturn {
  CellIndex cell;
  Point3f point;
};

/// Takes the mean of the returns of each cell; sorted by cell.
std::vector<HitCell> group_by_cell(const std::vector<CellReturn>& returns);

}  // namespace enfilade::grid_builder
