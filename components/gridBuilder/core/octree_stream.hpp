// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "components/gridBuilder/core/cell_store.hpp"

namespace enfilade::grid_builder {

/// States of the cells of a tile, in the order of offset_in_tile().
using TileStates = std::array<CellState, kTileCells>;

/// A cube of an octree: all of one state, or a node of its own. The values are those of OctoMap's stream.
enum class Branch : std::uint8_t { kNothing = 0, kFree = 1, kOccupied = 2, kNode = 3 };

/// A tile as a branch of an OctoMap; `bytes` is its part of the stream where it is a node.
struct PackedTile {
  Branch branch = Branch::kNothing;
  std::vector<std::int8_t> bytes;
};

/// Where a tile comes in the stream: the bits of its place, from the root down (z, y, x at each level).
using StreamKey = std::uint64_t;
StreamKey stream_key(const CellIndex& cell);
/// The first cell of the tile.
CellIndex first_cell(StreamKey key);

PackedTile pack_tile(const TileStates& states);

/// What OcTree::writeBinaryData writes of a pruned tree with these tiles: two bits a child for free, occupied
/// or a node, nodes depth first. Empty where nothing is known.
std::vector<std::int8_t> octree_stream(const std::map<StreamKey, PackedTile>& tiles);

}  // namespace enfilade::grid_builder
