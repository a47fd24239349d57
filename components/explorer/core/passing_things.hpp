// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "components/explorer/core/projected_grid.hpp"
#include "interfaces/model/sensing.hpp"

namespace enfilade::explorer {

/// Tells the trail of a walking person, which each sweep puts into the grid anew, from what stands there. The
/// robot watches for a while with a level sensor: where something was seen and at most times was not, nothing
/// stands.
class PassingThings {
 public:
  void clear();
  void begin_watch();
  /// One line of the level sensor; between begin_watch() and end_watch() the robot stands still.
  void watch(const Pose2& T_zone_base, const std::vector<Point3f>& points, double resolution_m);
  void end_watch();
  /// Middles of the obstacle columns where something was seen passing since clear(). Not those beside a
  /// column that may stand: what is low and stands at somebody's wayside is not seen by a level sensor.
  std::vector<Point2> trail(const ProjectedGrid& grid) const;

 private:
  std::unordered_map<std::uint64_t, int> lines_;  ///< of this watch that met something in the column
  int watched_ = 0;                               ///< lines
  std::unordered_set<std::uint64_t> passed_;
};

}  // namespace enfilade::explorer
