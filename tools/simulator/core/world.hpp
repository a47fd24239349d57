// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tools/simulator/core/world_truth.hpp"

namespace enfilade::simulator {

/// A vertical prism: everything in a world is one.
struct Solid {
  std::vector<Point2> base;  ///< convex, counter-clockwise, world frame
  double bottom_m = 0.0;
  double top_m = 0.0;
  bool glass = false;  ///< stops the robot, but the laser gets no echo from it
};

/// A solid that walks its waypoints one after the other, then from the last to the first, and so on.
struct MovingSolid {
  Solid solid;  ///< `base` about the origin
  std::vector<Point2> waypoints;
  double speed_m_s = 0.0;
};

/// Where the robot lives. The floor is at z = 0.
struct World {
  std::string name;
  std::vector<Solid> solids;
  std::vector<MovingSolid> moving;
  WorldTruth truth;
};

}  // namespace enfilade::simulator
