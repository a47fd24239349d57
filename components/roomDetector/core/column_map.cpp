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
  *this = ColumnMap();
  resolution_m_ = resolution_m;
}

void ColumnMap::apply(const std::vector<GridCell>& cells) {
  for (const GridCell& cell : cells) {
    const int signed_level = cell.z + kBelowFloor;
    if (signed_level < 0 || signed_level >= kLevels) continue;
    const auto level = static_cast<std::size_t>(signed_level);
    Column& column = column_at(cell);
    occupied_per_level_[level] += (cell.state == CellState::kOccupied) - column.occupied[level];
    column.occupied[level] = cell.state == CellState::kOccupied;
    column.free[level] = cell.state == CellState::kFree;
  }
}

Column& ColumnMap::column_at(const GridCell& cell) {
  std::int32_t& known = index_.at(cell.x, cell.y);
  if (known == ColumnIndex::kNone) {
    known = static_cast<std::int32_t>(columns_.size());
    // A grid grows for minutes: a quarter more room at a time wastes less than twice as much.
    if (columns_.size() == columns_.capacity()) columns_.reserve(columns_.size() * 5 / 4 + 1024);
    columns_.push_back({cell.x, cell.y, {}, {}});
    is_changed_.push_back(false);
  }
  const auto i = static_cast<std::size_t>(known);
  if (!is_changed_[i]) changed_.push_back(i);
  is_changed_[i] = true;
  return columns_[i];
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
