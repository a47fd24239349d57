// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "components/explorer/core/door_corridor.hpp"

namespace enfilade::explorer {

struct DoorJudgeConfig {
  int exit_beyond_cells = 40;   ///< fewer occupied cells above the floor beyond a door: nothing is there
  int exit_free_cells = 60;     ///< provided that at least so many free ones were seen
  double beyond_from_m = 0.40;  ///< counted in this range of distance from the wall's inner face
  double beyond_to_m = 8.0;
  double beyond_side_m = 3.0;   ///< and so far beside the door
  double floor_clear_m = 0.15;  ///< heights above the floor
  double highest_m = 3.0;
  DoorCorridorConfig corridor;
};

enum class DoorVerdict { kWay, kExit, kBlocked };

struct DoorJudgement {
  DoorVerdict verdict = DoorVerdict::kBlocked;
  std::optional<DoorCorridor> corridor;
  int beyond_occupied = 0, beyond_free = 0;
};

/// What a look from right in front of a door shows: a way into another room, empty ground, or no way through.
DoorJudgement judge_door(const ProjectedGrid& grid, const FloorMap& map, const PlacedDoor& door,
                         const DoorEstimate* gap, const DoorJudgeConfig& config);

}  // namespace enfilade::explorer
