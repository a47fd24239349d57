// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interfaces/geometry/rectangle.hpp"

namespace enfilade::evaluate {

struct MapConfig {
  double resolution_m = 0.05;  ///< of a pixel
  double least_fill = 0.9;     ///< a room that covers less of its rectangle is none
  double side_min_m = 1.5, side_max_m = 15.0;
};

/// The robot at one place of one room.
struct MapPlace {
  Rectangle truth;
  Point2 at = Point2::Zero();
  std::optional<Rectangle> found;
  double iou = 0.0;
};

/// One drawing of one floor plan.
struct MapResult {
  std::string name;
  bool is_furnished = false;
  int rooms = 0, rectangular = 0;  ///< drawn, and those that are rectangles within the limits
  std::vector<MapPlace> places;    ///< in the rectangular ones
  std::vector<Point2> walls;       ///< occupied cells, for the picture
};

/// Every NAME_gt_segmentation.png of the folder, with NAME.png and NAME_furnitures.png: `enfilade room` at
/// three places of each rectangular room. Throws std::runtime_error where there are none.
std::vector<MapResult> evaluate_maps(const std::string& folder, const MapConfig& config);

std::string to_json(const std::vector<MapResult>& results);
std::string to_markdown(const std::vector<MapResult>& results);
/// The plan with true rooms, what was found, and from where.
std::string to_svg(const MapResult& result);

}  // namespace enfilade::evaluate
