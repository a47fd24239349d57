// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "components/explorer/core/floor_map.hpp"

namespace enfilade::explorer {

struct PathPlannerConfig {
  double hard_radius_m = 0.27;  ///< the robot's centre keeps at least this far from obstacles (cell centres)
  double narrow_radius_m = 0.26;      ///< or this far, on a finer raster, where there is no other way
  double soft_radius_m = 0.50;        ///< closer than this costs more
  double unexplored_radius_m = 0.22;  ///< and at least this far from unexplored floor
  double soft_cost = 4.0;             ///< a metre at the hard radius costs 1 + this many metres
  double escape_m =
      0.7;  ///< this near its start a path may lead out of forbidden cells, never nearer to obstacles
};

struct Path {
  std::vector<Point2> points;
  double length_m = 0.0;
};

/// All cells that the robot can reach from one start, with the cheapest way to each (Dijkstra, 8 neighbours).
class Reach {
 public:
  Reach(const FloorMap& map, const PathPlannerConfig& config, const Point2& start);

  bool reaches(CellXY c) const;
  /// Metres, lengthened near obstacles; infinite where out of reach.
  double cost_m(CellXY c) const;
  /// Straightened where the straight line keeps as much clearance; ends at `goal` itself if that cell is
  /// within reach.
  std::optional<Path> path_to(const Point2& goal) const;
  /// The reachable cell nearest to `p` and at most `within_m` away from it.
  std::optional<Point2> nearest(const Point2& p, double within_m) const;

  const FloorMap& map() const { return map_; }

 private:
  void spread();
  double step_cost(CellXY c) const;
  double clearance_m(const Point2& a, const Point2& b) const;
  std::vector<Point2> straightened(const std::vector<Point2>& points) const;
  void drop_short_legs(std::vector<Point2>& corners) const;

  const FloorMap& map_;
  PathPlannerConfig config_;
  Point2 start_;
  double start_clearance_m_ = 0.0;
  std::vector<float> cost_;
  std::vector<std::int32_t> parent_;
};

}  // namespace enfilade::explorer
