// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/zone_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace enfilade::grid_builder {
namespace {

/// Half-open, in cells.
struct CellBox {
  int low_x = std::numeric_limits<int>::max(), low_y = low_x;
  int high_x = std::numeric_limits<int>::min(), high_y = high_x;

  void include_tile(const CellIndex& first) {
    low_x = std::min(low_x, first.x), high_x = std::max(high_x, first.x + kTileSide);
    low_y = std::min(low_y, first.y), high_y = std::max(high_y, first.y + kTileSide);
  }
  std::int64_t columns() const { return std::int64_t{high_x} - low_x; }
  std::int64_t rows() const { return std::int64_t{high_y} - low_y; }

  /// What of it lies in the square of `side` about a cell.
  CellBox near(const CellIndex& c, int side) const {
    const int half = side / 2;
    CellBox box;
    box.low_x = std::clamp(c.x - half, low_x, high_x), box.high_x = std::clamp(c.x + half, low_x, high_x);
    box.low_y = std::clamp(c.y - half, low_y, high_y), box.high_y = std::clamp(c.y + half, low_y, high_y);
    return box;
  }
};

std::int8_t occupancy_of(CellState state) {
  constexpr std::array kValues{OccupancyMap::kUnknown, OccupancyMap::kFree, OccupancyMap::kOccupied};
  return kValues.at(static_cast<std::size_t>(state));
}

OccupancyMap empty_map(const CellBox& box, double resolution_m) {
  OccupancyMap map{.resolution_m = static_cast<float>(resolution_m),
                   .columns = static_cast<std::uint32_t>(box.columns()),
                   .rows = static_cast<std::uint32_t>(box.rows()),
                   .T_frame_cells = {.x_m = box.low_x * resolution_m, .y_m = box.low_y * resolution_m}};
  map.cells.assign(std::size_t{map.columns} * map.rows, OccupancyMap::kUnknown);
  return map;
}

}  // namespace

ZonePictures::ZonePictures(const ZonePicturesConfig& config) : config_(config) {
  if (!(config.floor_to_m > config.floor_from_m) || config.max_floor_cells < 4)
    throw std::invalid_argument("floor_to_m must be above floor_from_m, max_floor_cells at least 4");
}

void ZonePictures::follow(const ZoneGrid& grid) {
  follows_ = true;
  grid.for_each_tile([this](const CellIndex& first) { waiting_.insert(stream_key(first)); });
}

void ZonePictures::stop_following() {
  follows_ = false;
  clear();
}

void ZonePictures::clear() {
  waiting_.clear();
  tiles_.clear();
  floors_.clear();
}

void ZonePictures::note(const std::vector<GridCell>& changes) {
  if (!follows_) return;
  constexpr int kTileMask = ~(kTileSide - 1);
  std::optional<CellIndex> last;  // cells come in the order of the beams: mostly one tile again and again
  for (const GridCell& c : changes) {
    const CellIndex first{c.x & kTileMask, c.y & kTileMask, c.z & kTileMask};
    if (last == first) continue;
    waiting_.insert(stream_key(first));
    last = first;
  }
}

bool ZonePictures::draw(const ZoneGrid& grid, std::size_t most) {
  for (; most > 0 && !waiting_.empty(); --most) {
    const StreamKey key = *waiting_.begin();
    waiting_.erase(waiting_.begin());
    const CellIndex first = first_cell(key);
    const TileStates states = grid.tile_states(first);
    tiles_[key] = pack_tile(states);
    const double resolution_m = grid.config().resolution_m;
    if (touches_floor(first.z, resolution_m)) floors_[key] = draw_floor(states, first.z, resolution_m);
  }
  return !waiting_.empty();
}

bool ZonePictures::touches_floor(int first_z, double resolution_m) const {
  return first_z * resolution_m < config_.floor_to_m &&
         (first_z + kTileSide) * resolution_m > config_.floor_from_m;
}

ZonePictures::Floor ZonePictures::draw_floor(const TileStates& states, int first_z,
                                             double resolution_m) const {
  Floor floor{};
  for (std::size_t i = 0; i < kTileCells; ++i) {
    const double z_m = (first_z + static_cast<int>(i % kTileSide) + 0.5) * resolution_m;
    if (z_m < config_.floor_from_m || z_m >= config_.floor_to_m) continue;
    CellState& column = floor[i / kTileSide];
    column = std::max(column, states[i]);  // occupied over free over unexplored
  }
  return floor;
}

std::vector<std::int8_t> ZonePictures::octree() const { return octree_stream(tiles_); }

OccupancyMap ZonePictures::floor(double resolution_m, const Point2& robot) const {
  CellBox box;
  for (const auto& [key, floor] : floors_) {
    const bool known =
        std::ranges::any_of(floor, [](CellState state) { return state != CellState::kUnexplored; });
    if (known) box.include_tile(first_cell(key));
  }
  if (box.low_x > box.high_x) return {.resolution_m = static_cast<float>(resolution_m)};
  if (box.columns() * box.rows() > config_.max_floor_cells) {
    const Eigen::Vector3d at(robot.x(), robot.y(), 0.0);
    box = box.near(cell_of(at / resolution_m), static_cast<int>(std::sqrt(config_.max_floor_cells)));
  }
  OccupancyMap map = empty_map(box, resolution_m);
  for (const auto& [key, floor] : floors_) {
    const CellIndex first = first_cell(key);
    for (int i = 0; i < kTileSide * kTileSide; ++i) {
      const int x = first.x + i / kTileSide, y = first.y + i % kTileSide;
      if (x < box.low_x || x >= box.high_x || y < box.low_y || y >= box.high_y) continue;
      const auto at = static_cast<std::size_t>((y - box.low_y) * box.columns() + x - box.low_x);
      const CellState state = floor[static_cast<std::size_t>(i)];
      map.cells[at] = std::max(map.cells[at], occupancy_of(state));
    }
  }
  return map;
}

}  // namespace enfilade::grid_builder
