// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/corner_choice.hpp"

#include <algorithm>
#include <utility>

namespace enfilade::room_detector {

CornerChoice CornerChoice::all(LineBlocks blocks) {
  CornerChoice choice{std::move(blocks), {}};
  for (int d = 0; d < 2; ++d) {
    for (int p = 0; p < 2; ++p)
      choice.corners[d][p].assign(choice.blocks[d].size() * choice.blocks[kD41 + p].size(), 1);
  }
  return choice;
}

void CornerChoice::clear() {
  for (auto& of_side : corners) {
    for (auto& of_quadrant : of_side) std::fill(of_quadrant.begin(), of_quadrant.end(), 0);
  }
}

int CornerChoice::last_partner(int side, int block, int half) const {
  const int axis = side / 2, is_far = side % 2;
  for (int other = count(2 * (1 - axis) + half) - 1; other >= 0; --other) {
    if (axis == 0 ? may(is_far, half, block, other) : may(half, is_far, other, block)) return other;
  }
  return -1;
}

CornerChoice CornerChoice::cut(int size, const std::function<bool(int, int)>& keep) const {
  CornerChoice parts;
  std::array<std::vector<int>, 4> whole;  // the block that each part is of
  for (int s = 0; s < 4; ++s) {
    for (int block = 0; block < count(s); ++block) {
      if (last_partner(s, block, 0) < 0 && last_partner(s, block, 1) < 0) continue;
      const LineBlock& all = blocks[s][static_cast<std::size_t>(block)];
      for (int line = all.nearest; line <= all.farthest;) {
        const int first = line;
        while (line <= all.farthest && line < first + size && keep(s, line)) ++line;
        if (line == first) {
          ++line;
          continue;
        }
        parts.blocks[s].push_back({first, line - 1});
        whole[s].push_back(block);
      }
    }
  }
  for (int d = 0; d < 2; ++d) {
    for (int p = 0; p < 2; ++p) {
      for (const int m : whole[d]) {
        for (const int n : whole[kD41 + p]) parts.corners[d][p].push_back(may(d, p, m, n));
      }
    }
  }
  return parts;
}

}  // namespace enfilade::room_detector
