// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <bitset>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "components/roomDetector/core/column_index.hpp"
#include "components/roomDetector/core/convex_region.hpp"
#include "interfaces/geometry/pose2.hpp"
#include "interfaces/model/grid.hpp"

namespace enfilade::room_detector {

/// Levels a column knows: kBelowFloor of them lie below z = 0. Cells higher or lower than that are ignored.
inline constexpr int kLevels = 256;
inline constexpr int kBelowFloor = 16;
using Levels = std::bitset<kLevels>;

/// The cell layer that holds height `z_m`: 0 lies on the floor. A height on a face between two layers belongs
/// to the upper one, whatever the rounding of the division.
int layer_of(double z_m, double resolution_m);
/// Level index of the cell layer that holds height `z_m`, clamped to what a column knows.
int level_of(double z_m, double resolution_m);
/// Height of the lower face of a level.
inline double bottom_of(int level, double resolution_m) { return (level - kBelowFloor) * resolution_m; }
/// Levels from ≤ l < to.
Levels level_range(int from, int to);

/// How many levels are set.
inline int count_of(const Levels& levels) {
  using Words = std::array<std::uint64_t, kLevels / 64>;
  int count = 0;
  for (const std::uint64_t word : std::bit_cast<Words>(levels))
    if (word != 0) count += std::popcount(word);
  return count;
}

/// All cells of the grid over one (x, y).
struct Column {
  std::int16_t x = 0, y = 0;
  Levels occupied;
  Levels free;
};

/// The grid, kept by column: the projection onto the floor plane that section III works on, and the heights
/// for the doors. Columns keep the order in which they were first heard of.
class ColumnMap {
 public:
  /// Forgets everything.
  void clear(double resolution_m);
  void apply(const std::vector<GridCell>& cells);

  double resolution_m() const { return resolution_m_; }
  const std::vector<Column>& columns() const { return columns_; }
  const Column* find(int x, int y) const;
  /// The column under a point; null where nothing is known.
  const Column* find(const Point2& p) const;
  Point2 centre(const Column& column) const {
    return {(column.x + 0.5) * resolution_m_, (column.y + 0.5) * resolution_m_};
  }
  std::size_t index_of(const Column& column) const {
    return static_cast<std::size_t>(&column - columns_.data());
  }
  /// Calls visit(index) for a column and those of its eight neighbours that are known.
  template <class Visit>
  void for_each_around(const Column& column, Visit visit) const {
    for (int x = column.x - 1; x <= column.x + 1; ++x) {
      for (int y = column.y - 1; y <= column.y + 1; ++y) {
        const std::int32_t i = index_.find(x, y);
        if (i != ColumnIndex::kNone) visit(static_cast<std::size_t>(i));
      }
    }
  }
  /// Calls visit(column) for the columns whose centre the region contains.
  template <class Visit>
  void visit_within(const ConvexRegion& region, Visit visit) const {
    const double half_m = 0.5 * ColumnIndex::kSide * resolution_m_;
    index_.for_each_tile([&](int x, int y, const ColumnIndex::Tile& tile) {
      const Point2 corner(x * resolution_m_, y * resolution_m_);
      if (!region.may_meet(corner + Point2::Constant(half_m), std::sqrt(2.0) * half_m)) return;
      for (const std::int32_t i : tile) {
        if (i == ColumnIndex::kNone) continue;
        const Column& column = columns_[static_cast<std::size_t>(i)];
        if (region.contains(centre(column))) visit(column);
      }
    });
  }
  /// How many occupied cells each level holds.
  const std::array<int, kLevels>& occupied_per_level() const { return occupied_per_level_; }
  /// Indices of the columns changed since the last call, each once.
  std::vector<std::size_t> take_changed();

 private:
  Column& column_at(const GridCell& cell);

  double resolution_m_ = 0.05;
  std::vector<Column> columns_;
  std::vector<bool> is_changed_;
  std::vector<std::size_t> changed_;
  ColumnIndex index_;
  std::array<int, kLevels> occupied_per_level_{};
};

}  // namespace enfilade::room_detector
