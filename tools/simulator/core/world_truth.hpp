// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interfaces/geometry/rectangle.hpp"
#include "interfaces/geometry/segment.hpp"

namespace enfilade::simulator {

/// A room as it was built: the rectangle of its inner wall faces, world frame.
struct TrueRoom {
  std::string name;
  Rectangle rectangle;
};

/// A door as it was built: the segment through the middle of its opening, halfway through the wall, world
/// frame.
struct TrueDoor {
  std::string name;
  Segment opening;
  double height_m = 0.0;             ///< underside of the lintel
  std::size_t room = 0;              ///< index into WorldTruth::rooms
  std::optional<std::size_t> other;  ///< the room behind it; none = outside
};

/// What an evaluation may know of a world and no component may.
struct WorldTruth {
  std::vector<TrueRoom> rooms;  ///< empty where the world is a bare map image
  std::vector<TrueDoor> doors;
  Pose2 T_world_start;  ///< where the robot is put down: odom and map start here
};

}  // namespace enfilade::simulator
