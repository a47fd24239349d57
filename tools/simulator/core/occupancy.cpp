// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/occupancy.hpp"

#include <algorithm>
#include <stdexcept>

#include "tools/simulator/core/shapes.hpp"

namespace enfilade::simulator {
namespace {

constexpr double kPlate_m = 0.1;

/// Cells [left, right) × [top, bottom) in image columns and rows.
struct Block {
  int left, right, top, bottom;
};

/// Runs of occupied cells, row by row; a run that repeats the columns of one in the row above is joined to
/// it.
std::vector<Block> blocks(const Occupancy& map) {
  std::vector<Block> done, open;
  for (int row = 0; row < map.rows; ++row) {
    std::vector<Block> now;
    for (int left = 0; left < map.columns; ++left) {
      if (!map.at(left, row)) continue;
      int right = left;
      while (right < map.columns && map.at(right, row)) ++right;
      now.push_back({left, right, row, row + 1});
      left = right;
    }
    for (const Block& above : open) {
      const auto same = std::ranges::find_if(
          now, [&above](const Block& b) { return b.left == above.left && b.right == above.right; });
      if (same == now.end())
        done.push_back(above);
      else
        same->top = above.top;
    }
    open = std::move(now);
  }
  done.insert(done.end(), open.begin(), open.end());
  return done;
}

std::vector<Point2> footprint(const Occupancy& map, const Block& block) {
  const double r = map.resolution_m;
  const double west = block.left * r, east = block.right * r;
  const double south = (map.rows - block.bottom) * r, north = (map.rows - block.top) * r;
  const Pose2& T = map.T_world_corner;
  return {T * Point2(west, south), T * Point2(east, south), T * Point2(east, north), T * Point2(west, north)};
}

/// Chessboard distance in cells from each cell to the nearest one that is not free or to the image's edge
/// (two passes).
std::vector<int> clearance(const Occupancy& map) {
  const int w = map.columns, h = map.rows;
  std::vector<int> cells(static_cast<std::size_t>(w) * h);
  const auto at = [&](int c, int r) {
    return c < 0 || r < 0 || c >= w || r >= h ? 0 : cells[static_cast<std::size_t>(r) * w + c];
  };
  for (int r = 0; r < h; ++r)
    for (int c = 0; c < w; ++c)
      cells[static_cast<std::size_t>(r) * w + c] =
          !map.is_free(c, r) ? 0
                             : 1 + std::min({at(c - 1, r), at(c - 1, r - 1), at(c, r - 1), at(c + 1, r - 1)});
  for (int r = h - 1; r >= 0; --r)
    for (int c = w - 1; c >= 0; --c) {
      int& cell = cells[static_cast<std::size_t>(r) * w + c];
      cell = std::min(cell, 1 + std::min({at(c + 1, r), at(c + 1, r + 1), at(c, r + 1), at(c - 1, r + 1)}));
    }
  return cells;
}

Pose2 roomiest_place(const Occupancy& map) {
  const std::vector<int> cells = clearance(map);
  const auto index = static_cast<int>(std::ranges::max_element(cells) - cells.begin());
  const double column = index % map.columns + 0.5, row = map.rows - index / map.columns - 0.5;
  const Point2 p = map.T_world_corner * Point2(column * map.resolution_m, row * map.resolution_m);
  return {p.x(), p.y(), map.T_world_corner.yaw_rad};
}

}  // namespace

World extrude(const std::string& name, const Occupancy& occupancy, const ExtrusionConfig& config) {
  if (config.wall_height_m <= 0) throw std::invalid_argument("ExtrusionConfig: the walls need a height");
  World world;
  world.name = name;
  for (const Block& block : blocks(occupancy))
    world.solids.push_back({footprint(occupancy, block), 0.0, config.wall_height_m, false});
  const std::vector<Point2> whole = footprint(occupancy, {0, occupancy.columns, 0, occupancy.rows});
  world.solids.push_back({whole, -kPlate_m, 0.0, false});
  if (config.ceiling_m)
    world.solids.push_back({whole, *config.ceiling_m, *config.ceiling_m + kPlate_m, false});
  world.truth.T_world_start = config.T_world_start ? *config.T_world_start : roomiest_place(occupancy);
  return world;
}

}  // namespace enfilade::simulator
