// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/cell_store.hpp"

namespace enfilade::grid_builder {

CellStore::CellStore(const Limits& limits) : limits_(limits) {
  for (std::size_t i = 0; i < kTileCells; ++i) {
    outside_.touch(i);
    no_memory_.touch(i);
  }
}

Cell CellStore::find(const CellIndex& c) const {
  const auto tile = tiles_.find(tile_key(c));
  return tile == tiles_.end() ? kUnexplored : tile->second->cell(offset_in_tile(c));
}

const Tile* CellStore::find_tile(const CellIndex& c) const {
  const auto tile = tiles_.find(tile_key(c));
  return tile == tiles_.end() ? nullptr : tile->second.get();
}

void CellStore::clear() {
  tiles_.clear();
  recent_.fill({});
}

CellIndex CellStore::cell_index(std::uint64_t tile, std::size_t offset) {
  const auto axis = [tile, offset](int tile_shift, int offset_shift) {
    const int tile_index = static_cast<std::int16_t>(tile >> tile_shift & 0xFFFF);
    return tile_index * kTileSide + static_cast<int>(offset >> offset_shift & (kTileSide - 1));
  };
  return {axis(32, 2 * kTileSideBits), axis(16, kTileSideBits), axis(0, 0)};
}

Tile* CellStore::find_or_create(const CellIndex& c) {
  const int bottom_z = c.z & ~(kTileSide - 1);
  if (bottom_z > limits_.highest_z || bottom_z + kTileSide <= limits_.lowest_z) return &outside_;
  const std::uint64_t key = tile_key(c);
  const auto known = tiles_.find(key);
  if (known != tiles_.end()) return known->second.get();
  if (tiles_.size() >= limits_.max_tiles) return &no_memory_;
  return tiles_.emplace(key, make_tile(bottom_z)).first->second.get();
}

std::unique_ptr<Tile> CellStore::make_tile(int bottom_z) const {
  auto tile = std::make_unique<Tile>();
  for (std::size_t i = 0; i < kTileCells; ++i) {
    const int z = bottom_z + static_cast<int>(i & (kTileSide - 1));
    if (z < limits_.lowest_z || z > limits_.highest_z) tile->touch(i);
  }
  return tile;
}

}  // namespace enfilade::grid_builder
