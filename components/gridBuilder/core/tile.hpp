// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "components/gridBuilder/core/cell_index.hpp"
#include "components/gridBuilder/core/certainties.hpp"

namespace enfilade::grid_builder {

inline constexpr int kTileSideBits = 4;
inline constexpr int kTileSide = 1 << kTileSideBits;
inline constexpr std::size_t kTileCells = std::size_t{1} << (3 * kTileSideBits);

/// Place of a cell in its tile.
inline std::size_t offset_in_tile(const CellIndex& c) {
  constexpr int kMask = kTileSide - 1;
  return static_cast<std::size_t>((c.x & kMask) << (2 * kTileSideBits) | (c.y & kMask) << kTileSideBits |
                                  (c.z & kMask));
}

/// A cube of 16³ cells, all unexplored at first; whether the line under way has touched them is marked.
///
/// Frequent certainties have small numbers. So a cell is a byte, its mark and seven bits for the number;
/// those that do not fit stand in a list.
class Tile {
 public:
  /// With a list of a thousand numbers, some seven times as many as a wall with noise brings about.
  static constexpr std::size_t kBytes = 2 * kTileCells;

  bool is_touched(std::size_t offset) const { return (cells_[offset] & kTouched) != 0; }
  Cell cell(std::size_t offset) const {
    const auto number = static_cast<Cell>(cells_[offset] & ~kTouched);
    return number < kRare ? number : find_rare(offset);
  }

  /// Where a mark stands.
  using Mark = std::uint8_t*;
  /// Changes a cell and marks it.
  Mark set(std::size_t offset, Cell cell) {
    if (cell >= kRare) set_rare(offset, cell);
    cells_[offset] = static_cast<std::uint8_t>(std::min(cell, kRare) | kTouched);
    return &cells_[offset];
  }
  Mark touch(std::size_t offset) {
    cells_[offset] |= kTouched;
    return &cells_[offset];
  }
  static void take_off(Mark mark) { *mark = static_cast<std::uint8_t>(*mark & ~kTouched); }

 private:
  static constexpr int kTouched = 0x80;
  static constexpr Cell kRare = 0x7F;  ///< stands for this number and all greater ones

  struct Rare {
    std::uint16_t offset;
    Cell cell;
  };

  std::vector<Rare>::const_iterator place_of_rare(std::size_t offset) const;
  Cell find_rare(std::size_t offset) const;
  void set_rare(std::size_t offset, Cell cell);

  std::array<std::uint8_t, kTileCells> cells_{};
  std::vector<Rare> rare_;  ///< by offset; those of cells that have become frequent again are left behind
};

}  // namespace enfilade::grid_builder
