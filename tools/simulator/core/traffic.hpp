// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tools/simulator/core/world.hpp"

namespace enfilade::simulator {

/// Walks the moving solids along their waypoints. One that would step onto the robot waits until the way is
/// free and, if that takes long, turns round, as people do.
class Traffic {
 public:
  Traffic(const World& world, double robot_radius_m, double robot_height_m);

  void step(double dt_s, const Point2& robot);

  bool empty() const { return walkers_.empty(); }
  const std::vector<Point2>& positions() const { return positions_; }
  /// Outlines, world frame, of those that the robot can touch.
  const std::vector<std::vector<Point2>>& outlines() const { return outlines_; }

 private:
  struct Walker {
    MovingSolid moving;
    std::size_t next = 0;  ///< the waypoint ahead
    bool backwards = false;
    double waited_s = 0.0;
  };

  static void turn_to_next(Walker& walker);
  Point2 advanced(Walker& walker, Point2 position, double way_m) const;
  static void wait(Walker& walker, double dt_s);
  void refresh_outlines();

  double keep_away_m_;
  double height_m_;
  std::vector<Walker> walkers_;
  std::vector<Point2> positions_;
  std::vector<std::vector<Point2>> outlines_;
};

}  // namespace enfilade::simulator
