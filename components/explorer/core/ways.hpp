// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/explorer/core/path_planner.hpp"

namespace enfilade::explorer {

/// What can be reached at the usual distance from obstacles and, worked out when it is asked for, at the
/// least. Both are as safe: where the robot is, is off by half a cell at most, and narrow ways are found on a
/// raster three times as fine.
class Ways {
 public:
  Ways(FloorMap map, const PathPlannerConfig& config, const Point2& start);
  Ways(const Ways&) = delete;
  Ways& operator=(const Ways&) = delete;

  const Reach& usual() const { return usual_; }
  /// The usual one where narrower ways are not allowed.
  const Reach& narrow();

 private:
  FloorMap map_;
  PathPlannerConfig config_;
  Point2 start_;
  Reach usual_;
  std::optional<FloorMap> fine_map_;
  std::optional<Reach> narrow_;
};

}  // namespace enfilade::explorer
