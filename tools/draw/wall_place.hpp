// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "interfaces/geometry/rectangle.hpp"
#include "interfaces/model/room.hpp"

namespace enfilade::draw {

/// Where a short text stands on a wall: the middle of it.
struct WallPlace {
  int wall = 0;
  double along_m = 0.0;    ///< from where the wall begins
  double inside_m = 0.17;  ///< from the wall into the room
};

/// A place for the length of `wall`, `text_m` long: on that wall or the one opposite, clear of what is taken
/// and as near to the middle as can be; farther into the room where there is no such place.
WallPlace place_dimension(const Rectangle& room, int wall, const std::vector<WallInterval>& taken,
                          double text_m);

}  // namespace enfilade::draw
