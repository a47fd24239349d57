// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "components/roomDetector/core/corner_choice.hpp"
#include "components/roomDetector/core/near_votes.hpp"
#include "components/roomDetector/core/plane_search.hpp"

namespace enfilade::room_detector {

/// What one search of rectangles around the robot asks in each plane.
struct AroundQuestion {
  const HoughSpace* space = nullptr;
  Point2 robot = Point2::Zero();
  WindowLimits sides;     ///< of both sides of a rectangle
  int near_bins = 0;      ///< so far out votes are counted for the first bounds
  int farthest_bins = 0;  ///< no better rectangle has a line farther from the robot
  NearVotes votes;
  bool only_votes_count = false;  ///< no tolls, no free space, nothing inside
  bool are_few = false;  ///< so few votes that spelling planes out is no more work than bounding them

  HoughSpace::Bins robot_bins(int angle) const { return space->bins_of(angle, robot); }

  /// Both pairs of sides have the robot's bin between them.
  PlaneLimits limits(int angle) const {
    const auto around = [&](int robot_bin) {
      WindowLimits limits = sides;
      limits.last_first = robot_bin - 1;
      limits.first_second = robot_bin + 1;
      return limits;
    };
    const auto bins = robot_bins(angle);
    return {around(bins.d), around(bins.p)};
  }

  Reaches reaches(int angle) const {
    const auto bins = robot_bins(angle);
    const int last = space->lattice().bins() - 1;
    return {std::min(bins.d, farthest_bins), std::min(last - bins.d, farthest_bins),
            std::min(bins.p, farthest_bins), std::min(last - bins.p, farthest_bins)};
  }
};

}  // namespace enfilade::room_detector
