// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>

#include "components/gridBuilder/core/tile.hpp"

namespace enfilade::grid_builder {

/// Dense cells in cubes of 16³ that come into being when first asked for, at most `max_tiles` of them. Cells
/// outside the layers lowest_z … highest_z do not exist: they count as touched for ever and stay unexplored,
/// so that who walks through them leaves them alone.
class CellStore {
 public:
  struct Limits {
    std::size_t max_tiles = 0;
    int lowest_z = 0, highest_z = 0;
  };

  explicit CellStore(const Limits& limits);
  // Not copied: recent_ points into the tiles.
  CellStore(const CellStore&) = delete;
  CellStore& operator=(const CellStore&) = delete;

  /// The tile that holds `c`; one in which no cell exists where it lies outside the layers or would be one
  /// too many.
  Tile& tile_of(const CellIndex& c) {
    const std::uint64_t key = tile_key(c);
    Recent& recent = recent_[recent_slot(c)];
    if (key != recent.key) recent = {key, find_or_create(c)};
    return *recent.tile;
  }
  /// Whether the tile is one that there was no memory for.
  bool is_missing(const Tile& tile) const { return &tile == &no_memory_; }

  /// kUnexplored where nothing is known.
  Cell find(const CellIndex& c) const;
  /// Null where there is none.
  const Tile* find_tile(const CellIndex& c) const;
  void clear();
  std::size_t tile_count() const { return tiles_.size(); }

  /// Visits the first cell of each tile, in no order to rely on.
  template <class Visit>
  void for_each_tile(Visit&& visit) const {
    for (const auto& [key, tile] : tiles_) visit(cell_index(key, 0));
  }
  /// Visits the known cells, in no order to rely on.
  template <class Visit>
  void for_each_known(Visit&& visit) const {
    for (const auto& [key, tile] : tiles_) {
      for (std::size_t i = 0; i < kTileCells; ++i) {
        const Cell cell = tile->cell(i);
        if (cell != kUnexplored) visit(cell_index(key, i), cell);
      }
    }
  }

 private:
  static constexpr std::uint64_t kNoKey = ~std::uint64_t{0};

  struct Recent {
    std::uint64_t key = kNoKey;
    Tile* tile = nullptr;
  };

  static std::uint64_t axis_key(int c) { return static_cast<std::uint16_t>(c >> kTileSideBits); }
  static std::uint64_t tile_key(const CellIndex& c) {
    return axis_key(c.x) << 32 | axis_key(c.y) << 16 | axis_key(c.z);
  }
  /// Tiles of a block of 16 × 16 × 8 (12.8 × 12.8 × 6.4 m at 0.05 m) have slots of their own.
  static std::size_t recent_slot(const CellIndex& c) {
    const auto axis = [](int i, int mask) { return static_cast<std::size_t>(i >> kTileSideBits & mask); };
    return axis(c.x, 15) << 7 | axis(c.y, 15) << 3 | axis(c.z, 7);
  }
  static CellIndex cell_index(std::uint64_t tile, std::size_t offset);

  Tile* find_or_create(const CellIndex& c);
  std::unique_ptr<Tile> make_tile(int bottom_z) const;

  Limits limits_;
  std::unordered_map<std::uint64_t, std::unique_ptr<Tile>> tiles_;
  Tile outside_, no_memory_;
  std::array<Recent, 2048> recent_{};  ///< spares most look-ups: the beams of a line share their tiles
};

}  // namespace enfilade::grid_builder
