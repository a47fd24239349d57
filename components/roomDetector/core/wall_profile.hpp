// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "components/roomDetector/core/column_map.hpp"
#include "interfaces/geometry/rectangle.hpp"

namespace enfilade::room_detector {

/// One upright slice of a wall plane, one cell wide: what the grid holds there, by level.
struct WallSlice {
  Levels occupied;
  Levels free;  ///< never where nothing was observed
};

/// Slices along wall `wall`, from its first corner, each `resolution_m` long; the last one may reach past the
/// corner. A level counts as occupied if a cell of the plane or of either neighbour is (the plane lies
/// somewhere within a cell), and as free only if a ray has gone through the plane: its cell and the one
/// behind it are free.
std::vector<WallSlice> profile_wall(const ColumnMap& map, const Rectangle& rectangle, int wall);

/// Cells of `band` over all slices.
struct SliceShares {
  double occupied = 0.0, free = 0.0;
  double unknown() const { return 1.0 - occupied - free; }
};
SliceShares shares_of(const std::vector<WallSlice>& slices, std::size_t from, std::size_t to,
                      const Levels& band);

}  // namespace enfilade::room_detector
