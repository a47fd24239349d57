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

inline constexpr double kCountedFrom_m = 0.3;

/// The grid, kept by column: the projection onto the floor plane that section III works on, and the heights
/// for the doors. Columns keep the order in which they were first heard of.
class ColumnMap {
 public:
  /// Cells at or above this height are counted by column.
  explicit ColumnMap(double counted_from_m = kCountedFrom_m) : counted_from_m_(counted_from_m) {}

  /// Forgets everything.
  void clear(double resolution_m);
  void apply(const std::vector<GridCell>& cells);

  double resolution_m() const { return resolution_m_; }
  const std::vector<Column>& columns() const { return columns_; }
  const Column* find(int x, int y) const;
  /// The column under a point; null where nothing is known.
  const Column* find(const Point2& p) const;
  Point2 centre(const Column& column) const { return centre(column.x, column.y); }
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
  /// Known cells of a column that are counted.
  struct Counts {
    std::uint8_t occupied = 0, free = 0;
  };
  static_assert(kLevels - kBelowFloor <= 255);
  /// Calls visit(counts) for the columns whose centre the region contains. A room beyond a door has
  /// thousands: the columns themselves are not looked at.
  template <class Visit>
  void visit_within(const ConvexRegion& region, Visit visit) const {
    const double half_m = 0.5 * ColumnIndex::kSide * resolution_m_;
    index_.for_each_tile([&](int x, int y, const ColumnIndex::Tile& tile) {
      const Point2 corner(x * resolution_m_, y * resolution_m_);
      if (!region.may_meet(corner + Point2::Constant(half_m), std::sqrt(2.0) * half_m)) return;
      for (std::size_t at = 0; at < tile.size(); ++at) {
        if (tile[at] == ColumnIndex::kNone) continue;
        const auto [in_x, in_y] = ColumnIndex::in_tile(at);
        if (region.contains(centre(x + in_x, y + in_y))) visit(counts_[static_cast<std::size_t>(tile[at])]);
      }
    });
  }
  /// How many occupied cells each level holds.
  const std::array<int, kLevels>& occupied_per_level() const { return occupied_per_level_; }
  /// Indices of the columns changed since the last call, each once.
  std::vector<std::size_t> take_changed();

 private:
  std::size_t index_at(const GridCell& cell);
  Point2 centre(int x, int y) const { return {(x + 0.5) * resolution_m_, (y + 0.5) * resolution_m_}; }

  double counted_from_m_;
  double resolution_m_ = 0.05;
  std::vector<Column> columns_;
  std::vector<Counts> counts_;  // of the columns
  std::vector<bool> is_changed_;
  std::vector<std::size_t> changed_;
  ColumnIndex index_;
  std::array<int, kLevels> occupied_per_level_{};
};

}  // namespace enfilade::room_detector
