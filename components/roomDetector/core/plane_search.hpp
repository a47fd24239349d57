// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "components/roomDetector/core/best_window.hpp"
#include "components/roomDetector/core/hough_plane.hpp"

namespace enfilade::room_detector {

/// The limits of d₁₂ < d₃₄ and of d₄₁ < d₂₃ in one plane.
struct PlaneLimits {
  WindowLimits d, p;
};

/// The best rectangle so far, shared by the planes of one search, and the work done.
struct Incumbent {
  BinRectangle rectangle;
  int score = kNever;
  int gap_bound = kNever;  ///< the highest bound that was left unexplored for want of budget
  int expansions = 0;
  int max_expansions = 0;
  int planes_opened = 0;

  bool has_budget() const { return expansions < max_expansions; }
  /// Whether something with this upper bound, whose first rectangle in order is `first`, may still win.
  bool may_lose_to(int bound, const BinRectangle& first) const {
    return bound > score || (bound == score && first < rectangle);
  }
  void offer(const BinRectangle& r, int r_score) {
    if (!may_lose_to(r_score, r)) return;
    rectangle = r;
    score = r_score;
  }
};

/// What bounds a plane from above without spelling it out: the sums of its lines, and the best pair of them
/// each way.
struct PlaneBound {
  int pair_d = kNever;  ///< of lines of constant d
  int pair_p = kNever;
  int total() const { return pair_d + pair_p; }
};
PlaneBound bound_of(const HoughSpace& space, int angle, const PlaneLimits& limits);

/// Improves `best` by every rectangle of the plane that can beat it.
void search_plane(const HoughPlane& plane, const HoughSpace& space, const PlaneLimits& limits,
                  Incumbent& best);

}  // namespace enfilade::room_detector
