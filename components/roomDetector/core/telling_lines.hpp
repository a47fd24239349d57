// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "components/roomDetector/core/best_window.hpp"
#include "components/roomDetector/core/corner_choice.hpp"
#include "components/roomDetector/core/near_votes.hpp"

namespace enfilade::room_detector {

/// The lines of a plane that the best rectangle can have where nothing but votes counts: no tolls, no free
/// space, nothing inside.
///
/// A side without a vote can be moved until it meets one, and the rectangle holds no less. Outward so for the
/// first of two sides, inward for the second: of equal rectangles the lexicographically first is asked for.
/// Only the limits of the sides stop it. Few votes leave few lines.
class TellingLines {
 public:
  void find(const NearVotes& votes, const HoughSpace::Binning& binning, const HoughSpace::Bins& robot,
            const Reaches& reaches, const WindowLimits& sides);
  /// Whether the line so many bins away from the robot's is one of them.
  bool hold(int side, int away) const {
    const Axis& a = axes_[static_cast<std::size_t>(side / 2)];
    return a.marks[static_cast<std::size_t>(a.before + (side % 2 ? away : -away))] != 0;
  }

 private:
  struct Axis {
    int before = 0;                   // bins before the robot's
    std::vector<std::uint8_t> marks;  // by bin
    void mark(int bin) {
      if (bin >= 0 && bin < static_cast<int>(marks.size())) marks[static_cast<std::size_t>(bin)] = 1;
    }
    void mark_limits(const WindowLimits& sides);
  };
  std::array<Axis, 2> axes_;
};

}  // namespace enfilade::room_detector
