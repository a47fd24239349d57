// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "components/roomDetector/core/column_map.hpp"
#include "components/roomDetector/core/hough_lattice.hpp"
#include "interfaces/model/room.hpp"

namespace enfilade::room_detector {

struct PaperDoorsConfig {
  double min_length_m = 0.6;  ///< the paper's l
};

/// Section III-B to the letter: eq. 14 and its seven steps, on all heights. `rectangle` is the one the Hough
/// space gave, in the grid's frame, `origin` where d = p = 0 lies.
std::vector<DoorEstimate> find_paper_doors(const ColumnMap& map, const HoughLattice& lattice,
                                           const Point2& origin, const Rectangle& rectangle,
                                           const PaperDoorsConfig& config);

/// Doors in the walls of `from`, named and measured in the walls of `to`: the same rectangle fitted better,
/// its sides perhaps renamed.
std::vector<DoorEstimate> rename_walls(std::vector<DoorEstimate> doors, const Rectangle& from,
                                       const Rectangle& to);

}  // namespace enfilade::room_detector
