// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace enfilade::room_detector {

/// The sides of a rectangle around the robot: before and behind it along d, and along p.
enum Side { kD12, kD34, kD41, kD23 };

/// How many lines on each side of the robot's bin can be walls: those 1 … n bins away from it.
using Reaches = std::array<int, 4>;

/// Lines next to each other on one side of the robot: the least and the largest distance from it.
struct LineBlock {
  int nearest, farthest;
};
/// By side, outward from the robot.
using LineBlocks = std::array<std::vector<LineBlock>, 4>;

/// Which corners can be part of a rectangle: blocks of lines, and for each side of d and of p the corners
/// between them, row by row over the blocks of d.
struct CornerChoice {
  LineBlocks blocks;
  std::array<std::array<std::vector<std::uint8_t>, 2>, 2> corners;

  /// All corners of these blocks.
  static CornerChoice all(LineBlocks blocks);

  int count(int side) const { return static_cast<int>(blocks[side].size()); }
  bool may(int d_side, int p_side, int d_block, int p_block) const {
    return corners[d_side][p_side][static_cast<std::size_t>(d_block * count(kD41 + p_side) + p_block)];
  }
  /// Adds the corners of two blocks of d, one on each side, with a block of p.
  void add(int p_side, int first, int second, int p_block) {
    const int width = count(kD41 + p_side);
    corners[0][p_side][static_cast<std::size_t>(first * width + p_block)] = 1;
    corners[1][p_side][static_cast<std::size_t>(second * width + p_block)] = 1;
  }
  void clear();
  /// The same with blocks of at most `size` lines, without those that have no corner.
  CornerChoice cut(int size) const {
    return cut(size, [](int, int) { return true; });
  }
  /// The same of the lines that keep(side, distance from the robot).
  CornerChoice cut(int size, const std::function<bool(int, int)>& keep) const;
  /// The last block on the other axis that has a corner with this one, −1 where none has.
  int last_partner(int side, int block, int half) const;
};

}  // namespace enfilade::room_detector
