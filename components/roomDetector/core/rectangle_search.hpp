// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "components/roomDetector/core/hough_plane.hpp"
#include "components/roomDetector/core/hough_space.hpp"

namespace enfilade::room_detector {

struct SearchConfig {
  double side_min_m = 1.5;  ///< "a specific rank of w and h" (III-A)
  double side_max_m = 15.0;
  bool robot_inside = true;  ///< only rectangles with the robot's bin strictly inside count
  int max_expansions =
      15'000;  ///< work after which the search gives up proving; 1 = looking once along a line
};

struct SearchResult {
  BinRectangle rectangle;
  int score = 0;               ///< H_r
  std::array<int, 4> walls{};  ///< h₁₂, h₂₃, h₃₄, h₄₁: what speaks for each wall
  int gap = 0;                 ///< no rectangle scores more than score + gap; 0 = the argmax is proven
  int expansions = 0;          ///< work done
  int planes_opened = 0;

  /// Whether at least one wall shows how far the room goes each way. Two parallel walls alone are a corridor
  /// of which no end has been seen.
  bool is_closed() const { return std::max(walls[0], walls[2]) > 0 && std::max(walls[1], walls[3]) > 0; }
};

/// argmax H_r (step 3 of the algorithm) over all rectangles of the space within the limits, by branch and
/// bound. Exact unless it runs into `max_expansions`; of equally good rectangles the lexicographically first.
/// Empty where no rectangle fits the limits.
class RectangleSearch {
 public:
  explicit RectangleSearch(const SearchConfig& config);
  std::optional<SearchResult> find_best(const HoughSpace& space, const std::optional<Point2>& robot);

 private:
  SearchConfig config_;
  HoughPlane plane_;  // kept for its memory
};

}  // namespace enfilade::room_detector
