// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "components/roomDetector/core/plane_search.hpp"

namespace enfilade::room_detector {

/// The paper's algorithm as it is written, slow and obvious: the whole table H(θ, d, p), cumulative in p, and
/// a loop over all rectangles. Only occupied cells count. What is mended: −d in the third arguments of eq. 8
/// and 9, half-open walls (see README), and θ from −π/4 to 3π/4, so that each rectangle comes once.
class LiteralHough {
 public:
  explicit LiteralHough(const HoughSpace& space);  // steps 1 and 2

  /// H(θ, d, p); p = -1 is before the first bin, θ = α + π/2 is `angle` + angles.
  int h(int angle, int d, int p) const { return p < 0 ? 0 : table_[index(angle, d, p)]; }
  /// Eq. 5–9.
  int score(const BinRectangle& r) const;
  /// Step 3 for one α: every rectangle within the limits.
  void search(int angle, const PlaneLimits& limits, Incumbent& best) const;

  /// How many entries the table has.
  static double table_size(const HoughLattice& lattice);

 private:
  std::size_t index(int angle, int d, int p) const {
    const auto n = static_cast<std::size_t>(bins_);
    return (static_cast<std::size_t>(angle) * n + static_cast<std::size_t>(d)) * n +
           static_cast<std::size_t>(p);
  }
  void add(int angle, int d, int p, int count);
  int mirror(int bin) const { return bins_ - 1 - bin; }

  int bins_, angles_;
  std::vector<std::int32_t> table_;
};

/// The best rectangle of one α by whole lines, as in a windowed Hough transform [4] whose window is the
/// space: points beyond the rectangle count like those on it.
void search_by_lines(const HoughSpace& space, int angle, const PlaneLimits& limits, Incumbent& best);

}  // namespace enfilade::room_detector
