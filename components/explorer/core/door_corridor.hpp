// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/explorer/core/door_geometry.hpp"
#include "components/explorer/core/floor_map.hpp"

namespace enfilade::explorer {

struct DoorCorridorConfig {
  double inside_m = 0.70;        ///< the robot stands so far inside before it goes through
  double inside_least_m = 0.40;  ///< where there is no room for that
  double beyond_m = 0.85;        ///< and so far beyond the wall's inner face afterwards
  double beyond_least_m = 0.60;
  double max_offset_m = 0.20;  ///< the line may lie so far beside the door's middle as the graph has it
  double clearance_m = 0.28;   ///< of the line to the centres of obstacle cells
  double narrow_clearance_m = 0.265;   ///< where no line keeps that; as much: never
  double enough_m = 0.45;              ///< more than this is no better
  double max_unexplored_share = 0.25;  ///< of the floor under the robot's way
};

/// The straight way through a door.
struct DoorCorridor {
  Pose2 from, to;  ///< both facing out
  double clearance_m = 0.0;
};

/// The line square to the door that keeps farthest from what stands beside it; nothing where none is free.
std::optional<DoorCorridor> find_corridor(const FloorMap& map, const PlacedDoor& door,
                                          const DoorCorridorConfig& config);

}  // namespace enfilade::explorer
