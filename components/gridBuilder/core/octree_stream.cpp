// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/octree_stream.hpp"

namespace enfilade::grid_builder {
namespace {

using Stream = std::vector<std::int8_t>;
using Tiles = std::map<StreamKey, PackedTile>;

constexpr int kLevels = 16;  // of every OctoMap
constexpr int kLevelsOverTiles = kLevels - kTileSideBits;
constexpr int kMiddleCell = 1 << (kLevels - 1);

/// Appends a node; `child(i)` appends what hangs below child i and tells what it is. Eight children of one
/// state become one leaf, and nothing is appended.
template <class Child>
Branch append_node(Stream& stream, Child&& child) {
  const std::size_t at = stream.size();
  stream.resize(at + 2);
  unsigned bits = 0;
  for (int i = 0; i < 8; ++i) bits |= static_cast<unsigned>(child(i)) << (2 * i);
  const unsigned first = bits & 3;
  if (first != static_cast<unsigned>(Branch::kNode) && bits == first * 0x5555) {
    stream.resize(at);
    return static_cast<Branch>(first);
  }
  stream[at] = static_cast<std::int8_t>(bits & 0xFF);
  stream[at + 1] = static_cast<std::int8_t>(bits >> 8);
  return Branch::kNode;
}

Branch append_cube(Stream& stream, const TileStates& states, const CellIndex& first, int side) {
  const int half = side / 2;
  return append_node(stream, [&](int i) {
    const CellIndex c{first.x + (i & 1 ? half : 0), first.y + (i & 2 ? half : 0),
                      first.z + (i & 4 ? half : 0)};
    if (half > 1) return append_cube(stream, states, c, half);
    return static_cast<Branch>(states[offset_in_tile(c)]);
  });
}

/// The tiles from `tile` on that lie in one cube of `level` levels over the tiles; moves on to the next one.
Branch append_tiles(Stream& stream, Tiles::const_iterator& tile, const Tiles& tiles, StreamKey cube,
                    int level) {
  if (tile == tiles.end() || tile->first >> (3 * level) != cube) return Branch::kNothing;
  if (level > 0)
    return append_node(stream, [&](int i) {
      return append_tiles(stream, tile, tiles, cube << 3 | static_cast<StreamKey>(i), level - 1);
    });
  const PackedTile& packed = tile++->second;
  stream.insert(stream.end(), packed.bytes.begin(), packed.bytes.end());
  return packed.branch;
}

}  // namespace

StreamKey stream_key(const CellIndex& cell) {
  StreamKey key = 0;
  for (int bit = kLevelsOverTiles - 1; bit >= 0; --bit) {
    const auto bit_of = [bit](int c) {
      return static_cast<StreamKey>((c + kMiddleCell) >> (kTileSideBits + bit) & 1);
    };
    key = key << 3 | bit_of(cell.z) << 2 | bit_of(cell.y) << 1 | bit_of(cell.x);
  }
  return key;
}

CellIndex first_cell(StreamKey key) {
  CellIndex cell{-kMiddleCell, -kMiddleCell, -kMiddleCell};
  for (int bit = 0; bit < kLevelsOverTiles; ++bit, key >>= 3) {
    const int side = 1 << (kTileSideBits + bit);
    if (key & 1) cell.x += side;
    if (key & 2) cell.y += side;
    if (key & 4) cell.z += side;
  }
  return cell;
}

PackedTile pack_tile(const TileStates& states) {
  PackedTile packed;
  packed.branch = append_cube(packed.bytes, states, {}, kTileSide);
  return packed;
}

std::vector<std::int8_t> octree_stream(const std::map<StreamKey, PackedTile>& tiles) {
  Stream stream;
  auto tile = tiles.begin();
  append_tiles(stream, tile, tiles, 0, kLevelsOverTiles);
  return stream;
}

}  // namespace enfilade::grid_builder
