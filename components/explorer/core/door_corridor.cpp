// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/door_corridor.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace enfilade::explorer {
namespace {

struct Obstacles {
  std::vector<Point2> centres;  ///< door frame: x out of the room, y along the wall
  std::vector<Point2> unexplored;
};

/// What lies around the door, in its frame.
Obstacles gather(const FloorMap& map, const Pose2& T_zone_door, const DoorCorridorConfig& c) {
  Obstacles found;
  const double side_m = c.max_offset_m + c.enough_m, margin_m = c.enough_m;
  const double reach_m = std::hypot(side_m, std::max(c.inside_m, c.beyond_m) + margin_m);
  const CellXY middle = map.cell_at(T_zone_door.translation());
  const int reach = static_cast<int>(std::ceil(reach_m / map.resolution_m()));
  const Pose2 T_door_zone = T_zone_door.inverse();
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      const Point2 p = T_door_zone * map.centre({x, y});
      if (std::abs(p.y()) > side_m || p.x() < -c.inside_m - margin_m || p.x() > c.beyond_m + margin_m)
        continue;
      const Floor floor = map.floor({x, y});
      if (floor == Floor::kObstacle) found.centres.push_back(p);
      if (floor == Floor::kUnexplored) found.unexplored.push_back(p);
    }
  }
  return found;
}

double clearance_m(const Obstacles& obstacles, double offset_m, double from_m, double to_m) {
  const Segment line{{from_m, offset_m}, {to_m, offset_m}};
  double least_m = 10.0;
  for (const Point2& p : obstacles.centres) least_m = std::min(least_m, distance(p, line));
  return least_m;
}

double unexplored_share(const Obstacles& obstacles, double offset_m, double from_m, double to_m,
                        const FloorMap& map) {
  constexpr double kHalfWidthM = 0.2;
  const auto count =
      std::count_if(obstacles.unexplored.begin(), obstacles.unexplored.end(), [&](const Point2& p) {
        return std::abs(p.y() - offset_m) <= kHalfWidthM && p.x() >= from_m && p.x() <= to_m;
      });
  const double cell_m2 = map.resolution_m() * map.resolution_m();
  return static_cast<double>(count) * cell_m2 / (2.0 * kHalfWidthM * (to_m - from_m));
}

/// The best line between two distances from the wall.
std::optional<DoorCorridor> best_line(const FloorMap& map, const Pose2& T_zone_door,
                                      const Obstacles& obstacles, double inside_m, double beyond_m,
                                      const DoorCorridorConfig& c) {
  std::optional<DoorCorridor> best;
  const int steps = static_cast<int>(std::floor(c.max_offset_m / (0.5 * map.resolution_m())));
  // From the middle outwards, so that a tie stays in the middle.
  for (int i = 0; i <= 2 * steps; ++i) {
    const double offset_m = 0.5 * map.resolution_m() * ((i + 1) / 2) * (i % 2 == 0 ? 1.0 : -1.0);
    const double free_m = std::min(c.enough_m, clearance_m(obstacles, offset_m, -inside_m, beyond_m));
    if (free_m < c.clearance_m || (best && free_m <= best->clearance_m + 1e-3)) continue;
    if (unexplored_share(obstacles, offset_m, -0.2, beyond_m, map) > c.max_unexplored_share) continue;
    best = DoorCorridor{T_zone_door * Pose2{-inside_m, offset_m, 0.0},
                        T_zone_door * Pose2{beyond_m, offset_m, 0.0}, free_m};
  }
  return best;
}

/// The one that leads farthest beyond, and inside as far as it can amply.
std::optional<DoorCorridor> longest_line(const FloorMap& map, const Pose2& T_zone_door,
                                         const Obstacles& obstacles, const DoorCorridorConfig& config) {
  constexpr double kStepM = 0.05, kAmplyM = 0.05;
  DoorCorridorConfig ample = config;
  ample.clearance_m += kAmplyM;
  for (double beyond_m = config.beyond_m; beyond_m >= config.beyond_least_m - 1e-6; beyond_m -= kStepM) {
    for (const DoorCorridorConfig& c : {ample, config}) {
      for (double inside_m = c.inside_m; inside_m >= c.inside_least_m - 1e-6; inside_m -= kStepM) {
        if (auto line = best_line(map, T_zone_door, obstacles, inside_m, beyond_m, c)) return line;
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<DoorCorridor> find_corridor(const FloorMap& map, const PlacedDoor& door,
                                          const DoorCorridorConfig& config) {
  const Pose2 T_zone_door = door.pose_at(0.0);
  const Obstacles obstacles = gather(map, T_zone_door, config);
  if (auto line = longest_line(map, T_zone_door, obstacles, config)) return line;
  if (config.narrow_clearance_m >= config.clearance_m) return std::nullopt;
  DoorCorridorConfig narrow = config;
  narrow.clearance_m = config.narrow_clearance_m;
  return longest_line(map, T_zone_door, obstacles, narrow);
}

}  // namespace enfilade::explorer
