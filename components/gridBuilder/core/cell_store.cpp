// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/cell_store.hpp"

namespace enfilade::grid_builder {

const Cell* CellStore::find(const CellIndex& c) const {
  const auto tile = tiles_.find(tile_key(c));
  if (tile == tiles_.end()) return nullptr;
  const Cell& cell = (*tile->second)[cell_offset(c)];
  return cell.known() ? &cell : nullptr;
}

void CellStore::clear() {
  tiles_.clear();
  recent_.fill({});
}

CellIndex CellStore::cell_index(std::uint64_t tile, std::size_t offset) {
  const auto axis = [tile, offset](int tile_shift, int offset_shift) {
    const int tile_index = static_cast<std::int16_t>(tile >> tile_shift & 0xFFFF);
    return tile_index * (1 << kSideBits) + static_cast<int>(offset >> offset_shift & kSideMask);
  };
  return {axis(32, 2 * kSideBits), axis(16, kSideBits), axis(0, 0)};
}

CellStore::Tile* CellStore::find_or_create(std::uint64_t key) {
  const auto known = tiles_.find(key);
  if (known != tiles_.end()) return known->second.get();
  if (tiles_.size() >= max_tiles_) return nullptr;
  return tiles_.emplace(key, std::make_unique<Tile>()).first->second.get();
}

}  // namespace enfilade::grid_builder
