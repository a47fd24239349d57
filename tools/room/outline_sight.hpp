// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interfaces/geometry/rectangle.hpp"
#include "tools/room/panorama.hpp"

namespace enfilade::room {

/// What the sights from inside a rectangle tell of its outline. Each sight crosses the outline once: it ends
/// there (wall), goes on (open), or ends before (hidden). A stretch hidden by something narrow is what its
/// two neighbours are, where they agree.
struct OutlineSight {
  double hidden_m = 0.0;     ///< outline behind furniture, or behind what was not seen
  double open_m = 0.0;       ///< outline that sights go through
  double wide_m = 0.0;       ///< of open stretches, what is wider than a door
  double narrow_gaps = 0.0;  ///< open stretches too narrow for a door
  double niches_m = 0.0;  ///< outline with something standing closely behind: it is not what bounds the room
  double seen_shares = 0.0;       ///< of each wall, what was seen of it: 0 … 4 together
  double bare_walls = 0.0;        ///< walls of which next to nothing was seen: 0 … 4
  double long_furniture_m = 0.0;  ///< of things inside, what is longer than furniture is
};

/// The robot stands in `outline`.
OutlineSight sight_of(const Rectangle& outline, const Panorama& panorama);

/// How implausible an outline is. The unit is what a metre of open outline costs.
double implausibility(const OutlineSight& sight);

}  // namespace enfilade::room
