// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/view_targets.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace enfilade::explorer {
namespace {

constexpr double kFloorHeightM = 0.1;

/// Whether the wall's plane is undecided here: nothing hit in it or in the cells beside it, and nothing seen
/// through it.
bool is_unexplored(const ProjectedGrid& grid, const Point2& on_wall, const Point2& normal, double z_m) {
  const int layer = grid.layer_at(z_m);
  for (int offset = -1; offset <= 1; ++offset) {
    const CellXY c = grid.cell_at(on_wall + normal * (offset * grid.resolution_m()));
    const CellState state = grid.state(c.x, c.y, layer);
    if (state == CellState::kOccupied || (offset >= 0 && state == CellState::kFree)) return false;
  }
  return true;
}

bool is_undecided_gap(const RoomEstimate& estimate, int wall, double along_m, double narrowest_m) {
  return std::any_of(estimate.doors.begin(), estimate.doors.end(), [&](const DoorEstimate& door) {
    return door.gap.wall == wall && door.state != DoorState::kOpen && door.gap.width_m() >= narrowest_m &&
           along_m >= door.gap.from_m && along_m <= door.gap.to_m;
  });
}

}  // namespace

ViewTargets::ViewTargets(const ViewTargetsConfig& config) : config_(config) {
  if (!(config.along_step_m > 0.0 && config.height_step_m > 0.0 && config.floor_step_m > 0.0)) {
    throw std::invalid_argument("ViewTargets: steps must be greater than 0");
  }
}

std::vector<ViewTarget> ViewTargets::find(const ProjectedGrid& grid, const RoomEstimate& estimate) const {
  std::vector<ViewTarget> targets;
  for (int wall = 0; wall < 4; ++wall) add_wall(grid, estimate, wall, targets);
  add_floor(grid, estimate.rectangle, targets);
  return targets;
}

std::vector<ViewTarget> ViewTargets::find_floor(const ProjectedGrid& grid, const Rectangle& area) const {
  std::vector<ViewTarget> targets;
  add_floor(grid, area, targets);
  return targets;
}

void ViewTargets::add_wall(const ProjectedGrid& grid, const RoomEstimate& estimate, int wall,
                           std::vector<ViewTarget>& targets) const {
  const Segment segment = estimate.rectangle.wall(wall);
  const Point2 along = segment.direction(), normal = estimate.rectangle.normal(wall);
  const double area_m2 = config_.along_step_m * config_.height_step_m;
  for (double s = 0.5 * config_.along_step_m; s < segment.length(); s += config_.along_step_m) {
    const Point2 p = segment.from + along * s;
    const bool gap = is_undecided_gap(estimate, wall, s, config_.narrowest_gap_m);
    for (double z = config_.band_from_m + 0.5 * config_.height_step_m; z < config_.band_to_m;
         z += config_.height_step_m) {
      if (!is_unexplored(grid, p, normal, z)) continue;
      targets.push_back(target(grid, {p.x(), p.y(), z}, area_m2 * (gap ? config_.gap_weight : 1.0)));
    }
  }
}

void ViewTargets::add_floor(const ProjectedGrid& grid, const Rectangle& area,
                            std::vector<ViewTarget>& targets) const {
  const double step = config_.floor_step_m, worth_m2 = config_.floor_weight * step * step;
  for (double y = -0.5 * area.height_m + step; y <= 0.5 * area.height_m - step; y += step) {
    for (double x = -0.5 * area.width_m + step; x <= 0.5 * area.width_m - step; x += step) {
      const Point2 p = area.pose() * Point2{x, y};
      if (grid.floor(grid.cell_at(p)) != Floor::kUnexplored) continue;
      targets.push_back(target(grid, {p.x(), p.y(), kFloorHeightM}, worth_m2));
    }
  }
}

ViewTarget ViewTargets::target(const ProjectedGrid& grid, const Eigen::Vector3d& at, double worth_m2) const {
  const CellXY c = grid.cell_at({at.x(), at.y()});
  const auto part = [](int i) { return static_cast<std::uint64_t>(static_cast<std::uint16_t>(i)); };
  const std::uint64_t key = part(c.x) << 32 | part(c.y) << 16 | part(grid.layer_at(at.z()));
  const auto vain = vain_.find(key);
  return {at, vain == vain_.end() ? worth_m2 : worth_m2 * std::pow(config_.futility, vain->second), key};
}

}  // namespace enfilade::explorer
