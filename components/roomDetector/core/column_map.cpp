// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/column_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enfilade::room_detector {

int layer_of(double z_m, double resolution_m) {
  return static_cast<int>(std::floor(z_m / resolution_m + 1e-6));
}

int level_of(double z_m, double resolution_m) {
  return std::clamp(layer_of(z_m, resolution_m) + kBelowFloor, 0, kLevels);
}

Levels level_range(int from, int to) {
  Levels levels;
  for (int l = std::max(from, 0); l < std::min(to, kLevels); ++l) levels.set(static_cast<std::size_t>(l));
  return levels;
}

void ColumnMap::clear(double resolution_m) {
  *this = ColumnMap(counted_from_m_);
  resolution_m_ = resolution_m;
}

void ColumnMap::apply(const std::vector<GridCell>& cells) {
  const auto counted_from = static_cast<std::size_t>(level_of(counted_from_m_, resolution_m_));
  for (const GridCell& cell : cells) {
    const int signed_level = cell.z + kBelowFloor;
    if (signed_level < 0 || signed_level >= kLevels) continue;
    const auto level = static_cast<std::size_t>(signed_level);
    const std::size_t i = index_at(cell);
    Column& column = columns_[i];
    const bool is_occupied = cell.state == CellState::kOccupied, is_free = cell.state == CellState::kFree;
    const int more_occupied = is_occupied - column.occupied[level], more_free = is_free - column.free[level];
    occupied_per_level_[level] += more_occupied;
    if (level >= counted_from) {
      counts_[i].occupied = static_cast<std::uint8_t>(counts_[i].occupied + more_occupied);
      counts_[i].free = static_cast<std::uint8_t>(counts_[i].free + more_free);
    }
    column.occupied[level] = is_occupied;
    column.free[level] = is_free;
  }
}

std::size_t ColumnMap::index_at(const GridCell& cell) {
  std::int32_t& known = index_.at(cell.x, cell.y);
  if (known == ColumnIndex::kNone) {
    known = static_cast<std::int32_t>(columns_.size());
    // A grid grows for minutes: a quarter more room at a time wastes less than twice as much.
    if (columns_.size() == columns_.capacity()) columns_.reserve(columns_.size() * 5 / 4 + 1024);
    columns_.push_back({cell.x, cell.y, {}, {}});
    counts_.emplace_back();
    is_changed_.push_back(false);
  }
  const auto i = static_cast<std::size_t>(known);
  if (!is_changed_[i]) changed_.push_back(i);
  is_changed_[i] = true;
  return i;
}

const Column* ColumnMap::find(int x, int y) const {
  const std::int32_t i = index_.find(x, y);
  return i == ColumnIndex::kNone ? nullptr : &columns_[static_cast<std::size_t>(i)];
}

const Column* ColumnMap::find(const Point2& p) const {
  return find(static_cast<int>(std::floor(p.x() / resolution_m_)),
              static_cast<int>(std::floor(p.y() / resolution_m_)));
}

std::vector<std::size_t> ColumnMap::take_changed() {
  for (const std::size_t i : changed_) is_changed_[i] = false;
  return std::exchange(changed_, {});
}

}  // namespace enfilade::room_detector
