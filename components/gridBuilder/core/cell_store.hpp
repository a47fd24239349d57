// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>

#include "components/gridBuilder/core/cell_index.hpp"

namespace enfilade::grid_builder {

/// What the grid remembers of one cell.
struct Cell {
  float log_odds = 0.0F;
  /// Twice the number of the line that touched it last, plus one if that line hit it; 0 = unexplored.
  std::uint32_t touched = 0;

  bool known() const { return touched != 0; }
};

/// Dense cells in cubes of 16³ that come into being when first touched, at most `max_tiles` of them (32 KiB
/// each).
class CellStore {
 public:
  explicit CellStore(std::size_t max_tiles) : max_tiles_(max_tiles) {}

  /// Null where the tile would be one too many.
  Cell* touch(const CellIndex& c) {
    const std::uint64_t key = tile_key(c);
    Recent& recent = recent_[recent_slot(c)];
    if (key != recent.key) recent = {key, find_or_create(key)};
    return recent.tile ? &(*recent.tile)[cell_offset(c)] : nullptr;
  }

  const Cell* find(const CellIndex& c) const;
  void clear();
  std::size_t tile_count() const { return tiles_.size(); }

  /// Visits the known cells, in no order to rely on.
  template <class Visit>
  void for_each_known(Visit&& visit) const {
    for (const auto& [key, tile] : tiles_) {
      for (std::size_t i = 0; i < kTileCells; ++i) {
        if ((*tile)[i].known()) visit(cell_index(key, i), (*tile)[i]);
      }
    }
  }

 private:
  static constexpr int kSideBits = 4;
  static constexpr int kSideMask = (1 << kSideBits) - 1;
  static constexpr std::size_t kTileCells = std::size_t{1} << (3 * kSideBits);
  static constexpr std::uint64_t kNoKey = ~std::uint64_t{0};
  using Tile = std::array<Cell, kTileCells>;

  struct Recent {
    std::uint64_t key = kNoKey;
    Tile* tile = nullptr;
  };

  static std::uint64_t axis_key(int c) { return static_cast<std::uint16_t>(c >> kSideBits); }
  static std::uint64_t tile_key(const CellIndex& c) {
    return axis_key(c.x) << 32 | axis_key(c.y) << 16 | axis_key(c.z);
  }
  static std::size_t cell_offset(const CellIndex& c) {
    return static_cast<std::size_t>((c.x & kSideMask) << (2 * kSideBits) | (c.y & kSideMask) << kSideBits |
                                    (c.z & kSideMask));
  }
  /// Tiles of a block of 8 × 8 × 8 (6.4 m at 0.05 m) have slots of their own.
  static std::size_t recent_slot(const CellIndex& c) {
    const auto axis = [](int i) { return static_cast<std::size_t>(i >> kSideBits & 7); };
    return axis(c.x) << 6 | axis(c.y) << 3 | axis(c.z);
  }
  static CellIndex cell_index(std::uint64_t tile, std::size_t offset);

  Tile* find_or_create(std::uint64_t key);

  std::size_t max_tiles_;
  std::unordered_map<std::uint64_t, std::unique_ptr<Tile>> tiles_;
  std::array<Recent, 512> recent_{};  ///< spares most look-ups: the beams of a line share their tiles
};

}  // namespace enfilade::grid_builder
