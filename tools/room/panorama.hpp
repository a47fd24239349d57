// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tools/room/survey.hpp"

namespace enfilade::room {

/// One look from a place: how far it is free, and whether something stands there.
struct Sight {
  Point2 direction;      ///< unit vector
  double range_m = 0.0;  ///< up to what stands there, or to where nothing is known
  bool meets = false;    ///< something stands there
};

/// Sights all around a place, at even angles, counter-clockwise.
struct Panorama {
  Point2 place;
  double resolution_m = 0.05;  ///< of the grid looked at
  std::vector<Sight> sights;

  Point2 end_of(const Sight& s) const { return place + s.range_m * s.direction; }
  /// Angle between two sights.
  double step_rad() const { return 2.0 * kPi / static_cast<double>(sights.size()); }
};

/// Looks around in a survey of one layer.
Panorama look_around(const Survey& view, const Point2& place);

}  // namespace enfilade::room
