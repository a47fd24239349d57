// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "components/roomDetector/core/column_map.hpp"
#include "components/roomDetector/core/jamb_fit.hpp"
#include "interfaces/model/room_diagnostics.hpp"

namespace enfilade::room_detector {

struct DoorFinderConfig {
  double band_from_m = 0.15;         ///< heights that tell a door from a wall: above the floor …
  double band_to_m = 1.9;            ///< … and below the lintel
  double max_occupied_share = 0.10;  ///< of a slice's levels; more is wall
  double min_free_share = 0.40;      ///< of a slice's levels observed free; less is not known to be open
  double sill_m = 0.45;              ///< an opening that is not free below this is a window or a hatch
  double min_width_m = 0.6;
  double max_width_m = 3.0;  ///< wider than a door leaf, for openings without one; more is a wall not there
  double min_unexplored_m = 0.2;     ///< shorter stretches without evidence are not reported
  double min_returns_behind = 30.0;  ///< seen through the gap; fewer: glass, or nothing in reach of the laser
  double beyond_from_m = 0.3;        ///< what lies so far behind the wall …
  double beyond_to_m = 8.0;          ///< … to so far tells a room from open ground
  JambFitConfig jamb;
};

/// Returns of the laser, of all heights, from one place of the robot.
struct Sightings {
  Point2 from;
  PlacedHits returns;
};

/// The gaps of all four walls, by wall and then by position, and how much of the walls was never observed.
struct WallGaps {
  std::vector<DoorEstimate> doors;
  double unexplored_share = 1.0;            ///< of the cells of the wall planes within the band
  std::vector<GapDiagnostics> diagnostics;  ///< of every gap, and of openings that are no doors
};

/// Doors by evidence: eq. 14 asks for segments without points; this asks, besides, that somebody has looked
/// there. Gaps that were seen free down to the floor are open doors, gaps that were not seen are unexplored
/// wall.
class DoorFinder {
 public:
  explicit DoorFinder(const DoorFinderConfig& config);
  /// `hits`: returns at the heights of band_from_m … band_to_m, from which the ends of open gaps are fitted.
  /// `sightings`: without any, nothing is asked about what lies behind a gap.
  WallGaps find(const ColumnMap& map, const Rectangle& rectangle, std::span<const PlacedHits> hits = {},
                std::span<const Sightings> sightings = {}) const;

 private:
  DoorFinderConfig config_;
};

}  // namespace enfilade::room_detector
