// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/door_judge.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::explorer {
namespace {

ProjectedGrid::Count count_beyond(const ProjectedGrid& grid, const PlacedDoor& door,
                                  const DoorJudgeConfig& c) {
  ProjectedGrid::Count total;
  const Pose2 T_zone_door = door.pose_at(0.0), T_door_zone = T_zone_door.inverse();
  const double side_m = 0.5 * door.width_m + c.beyond_side_m;
  const CellXY middle = grid.cell_at(door.middle);
  const int reach = static_cast<int>(std::ceil(std::hypot(side_m, c.beyond_to_m) / grid.resolution_m()));
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      const Point2 p = T_door_zone * grid.centre({x, y});
      if (p.x() < c.beyond_from_m || p.x() > c.beyond_to_m || std::abs(p.y()) > side_m) continue;
      const auto column = grid.count({x, y}, c.floor_clear_m, c.highest_m);
      total.occupied += column.occupied;
      total.free += column.free;
    }
  }
  return total;
}

}  // namespace

DoorJudgement judge_door(const ProjectedGrid& grid, const FloorMap& map, const PlacedDoor& door,
                         const DoorEstimate* gap, const DoorJudgeConfig& config) {
  const auto beyond = count_beyond(grid, door, config);
  DoorJudgement judgement{.beyond_occupied = beyond.occupied, .beyond_free = beyond.free};
  if (gap) {
    judgement.beyond_occupied =
        std::max(judgement.beyond_occupied, static_cast<int>(gap->evidence.beyond_occupied_cells));
  }
  if (judgement.beyond_occupied < config.exit_beyond_cells &&
      judgement.beyond_free >= config.exit_free_cells) {
    judgement.verdict = DoorVerdict::kExit;
    return judgement;
  }
  judgement.corridor = find_corridor(map, door, config.corridor);
  if (judgement.corridor) judgement.verdict = DoorVerdict::kWay;
  return judgement;
}

}  // namespace enfilade::explorer
