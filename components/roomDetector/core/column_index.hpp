// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace enfilade::room_detector {

/// Numbers by (x, y), in tiles of 16 × 16: neighbours are asked for one after the other, and most of them lie
/// in the tile that was asked last. That tile is remembered by find(), too: const or not, one thread at a
/// time.
class ColumnIndex {
 public:
  static constexpr std::int32_t kNone = -1;
  static constexpr int kBits = 4, kSide = 1 << kBits;
  using Tile = std::array<std::int32_t, kSide * kSide>;

  /// kNone where nothing was put.
  std::int32_t find(int x, int y) const {
    const std::uint32_t key = key_of(x, y);
    if (key != last_key_) {
      const auto known = tile_of_.find(key);
      if (known == tile_of_.end()) return kNone;
      last_key_ = key;
      last_tile_ = known->second;
    }
    return tiles_[last_tile_][place_of(x, y)];
  }
  /// The number at (x, y), to be changed; kNone at first.
  std::int32_t& at(int x, int y) {
    const std::uint32_t key = key_of(x, y);
    if (key != last_key_) {
      const auto [tile, is_new] = tile_of_.try_emplace(key, tiles_.size());
      if (is_new) {
        tiles_.emplace_back().fill(kNone);
        corners_.push_back({x & ~(kSide - 1), y & ~(kSide - 1)});
      }
      last_key_ = key;
      last_tile_ = tile->second;
    }
    return tiles_[last_tile_][place_of(x, y)];
  }
  struct Place {
    int x, y;
  };
  /// Where entry `i` of a tile lies, from its corner.
  static Place in_tile(std::size_t i) {
    return {static_cast<int>(i) >> kBits, static_cast<int>(i) & (kSide - 1)};
  }
  /// Calls visit(lowest x, lowest y, tile) for one tile after the other.
  template <class Visit>
  void for_each_tile(Visit&& visit) const {
    for (std::size_t i = 0; i < tiles_.size(); ++i) visit(corners_[i].x, corners_[i].y, tiles_[i]);
  }

 private:
  // No tile of 16-bit coordinates has it.
  static constexpr std::uint32_t kNoKey = 0xFFFF'FFFF;

  static std::uint32_t key_of(int x, int y) {
    const auto axis = [](int i) { return static_cast<std::uint32_t>((i >> kBits) & 0x7FFF); };
    return axis(x) << 16 | axis(y);
  }
  static std::size_t place_of(int x, int y) {
    return static_cast<std::size_t>((x & (kSide - 1)) << kBits | (y & (kSide - 1)));
  }

  std::unordered_map<std::uint32_t, std::size_t> tile_of_;
  std::vector<Tile> tiles_;
  std::vector<Place> corners_;  // of the tiles
  mutable std::uint32_t last_key_ = kNoKey;
  mutable std::size_t last_tile_ = 0;
};

}  // namespace enfilade::room_detector
