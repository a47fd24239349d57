// SPDX-License-Identifier: Apache-2.0
#include "tools/room/view.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace enfilade::room {
namespace {

constexpr double kReach_m = 16.0;
constexpr double kFrom_m = 0.3, kTo_m = 2.4, kEvery_m = 0.1;  // heights of the level beams
// A beam shows the wall this deep behind the face it meets: where returns were measured they scatter, and
// walls of grids are as thick; where a map is drawn the face itself is known.
constexpr double kWall_m = 0.15, kDrawnWall_m = 0.10;
constexpr int kUnknownBridged = 2;  // cells that no measurement happened to pass

/// Columns about the robot's.
class Raster {
 public:
  Raster(int x, int y, int reach)
      : x0_(x - reach),
        y0_(y - reach),
        side_(2 * reach + 1),
        values_(static_cast<std::size_t>(side_) * side_) {}

  bool has(int x, int y) const { return x >= x0_ && y >= y0_ && x < x0_ + side_ && y < y0_ + side_; }
  std::uint8_t& at(int x, int y) { return values_[static_cast<std::size_t>(x - x0_) * side_ + (y - y0_)]; }
  void clear() { std::fill(values_.begin(), values_.end(), std::uint8_t{0}); }

 private:
  int x0_, y0_, side_;
  std::vector<std::uint8_t> values_;
};

struct Viewer {
  Point2 place;  ///< in cells
  int reach = 0;
  int wall = 0;
  Raster layer, seen;

  Viewer(const Point2& at, double resolution_m, double wall_m)
      : place(at / resolution_m),
        reach(static_cast<int>(kReach_m / resolution_m)),
        wall(std::max(1, static_cast<int>(std::lround(wall_m / resolution_m)))),
        layer(column_x(), column_y(), reach),
        seen(column_x(), column_y(), reach) {}

  int column_x() const { return static_cast<int>(std::floor(place.x())); }
  int column_y() const { return static_cast<int>(std::floor(place.y())); }

  /// One beam, in steps of half a cell.
  void look(double angle) {
    const Point2 step = 0.5 * Point2(std::cos(angle), std::sin(angle));
    int unknown = 0, within_wall = 0;
    for (int i = 0; i < 2 * reach; ++i) {
      const Point2 p = place + i * step;
      const int x = static_cast<int>(std::floor(p.x())), y = static_cast<int>(std::floor(p.y()));
      if (!layer.has(x, y)) return;
      const auto state = static_cast<CellState>(layer.at(x, y));
      if (state == CellState::kOccupied || within_wall > 0) ++within_wall;
      unknown = state == CellState::kUnexplored ? unknown + 1 : 0;
      if (within_wall > 2 * wall || (within_wall == 0 && unknown > 2 * kUnknownBridged)) return;
      seen.at(x, y) = 1;
    }
  }

  void look_around() {
    const int beams = static_cast<int>(2.0 * kPi * reach);
    for (int i = 0; i < beams; ++i) look(2.0 * kPi * i / beams);
  }
};

}  // namespace

Survey seen_from(const Point2& place, const Survey& survey) {
  const double r = survey.resolution_m;
  Viewer viewer(place, r, survey.is_drawn() ? kDrawnWall_m : kWall_m);
  const int every = survey.is_planar ? 1 : std::max(1, static_cast<int>(kEvery_m / r));
  for (int z = static_cast<int>(kFrom_m / r); z < static_cast<int>(kTo_m / r); z += every) {
    if (survey.is_planar && z != planar_layer(r)) continue;
    viewer.layer.clear();
    for (const GridCell& c : survey.cells) {
      if (c.z == z && viewer.layer.has(c.x, c.y))
        viewer.layer.at(c.x, c.y) = static_cast<std::uint8_t>(c.state);
    }
    viewer.look_around();
  }
  Survey view = survey;
  std::erase_if(view.cells, [&](const GridCell& c) {
    return !viewer.seen.has(c.x, c.y) || viewer.seen.at(c.x, c.y) == 0;
  });
  std::erase_if(view.hits, [&](const CellHit& hit) {
    const int x = static_cast<int>(std::floor(hit.x_m / r)), y = static_cast<int>(std::floor(hit.y_m / r));
    return !viewer.seen.has(x, y) || viewer.seen.at(x, y) == 0;
  });
  return view;
}

}  // namespace enfilade::room
