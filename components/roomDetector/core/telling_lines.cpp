// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/telling_lines.hpp"

namespace enfilade::room_detector {

void TellingLines::find(const NearVotes& votes, const HoughSpace::Binning& binning,
                        const HoughSpace::Bins& robot, const Reaches& reaches, const WindowLimits& sides) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    Axis& a = axes_[axis];
    a.before = reaches[2 * axis];
    a.marks.assign(static_cast<std::size_t>(a.before + 1 + reaches[2 * axis + 1]), 0);
    a.mark(0);
    a.mark(a.before + 1);
  }
  Axis &of_d = axes_[0], &of_p = axes_[1];
  votes.for_each_chunk(binning, votes.size(), [&](const NearVotes::Chunk& c) {
    for (int i = 0; i < c.size; ++i) {
      of_d.mark(c.d[i] - robot.d + of_d.before);
      of_p.mark(c.p[i] - robot.p + of_p.before);
    }
  });
  for (Axis& a : axes_) a.mark_limits(sides);
}

/// The first of two sides can lie as far before the second as the limits allow, the second as near to the
/// first.
void TellingLines::Axis::mark_limits(const WindowLimits& sides) {
  const std::vector<std::uint8_t> known = marks;
  for (int bin = 0; bin < static_cast<int>(known.size()); ++bin) {
    if (known[static_cast<std::size_t>(bin)] == 0) continue;
    mark(bin > before ? bin - sides.max_gap : bin + sides.min_gap);
  }
}

}  // namespace enfilade::room_detector
