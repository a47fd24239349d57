// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "interfaces/model/room.hpp"
#include "interfaces/model/topological_map.hpp"

namespace enfilade::draw {

/// What one scan of a room looked like, zone frame.
struct ScanFigure {
  std::string title;
  RoomEstimate estimate;
  std::vector<Point2> points;  ///< returns above the floor, projected onto it
  Pose2 T_zone_base;
  double margin_m = 0.6;  ///< of surroundings shown
  double point_px = 1.6;  ///< side of a point
};

/// The paper's figures 4 and 5: points, the rectangle over them, wall regions red, door regions green. A gap
/// that nobody has looked at is drawn apart from a door: grey and dashed.
std::string draw_scan(const ScanFigure& figure);

/// The paper's figure 6: all rooms and doors of the map in the map frame, with dimensions.
std::string draw_floor_plan(const TopologicalMap& map, const std::string& title);

}  // namespace enfilade::draw
