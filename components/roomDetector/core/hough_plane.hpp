// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "components/roomDetector/core/hough_space.hpp"

namespace enfilade::room_detector {

/// One plane θ = α of the Hough space, spelled out: cumulative along p (the paper's H at α) and along d (the
/// paper's H at α + π/2, mirrored), and as an integral image of what must not lie inside a room.
///
/// Counting: each wall includes its first corner, going round the contour, and excludes its last. So every
/// bin of the contour counts exactly once. (Taken literally, eq. 4 on a table that includes p itself counts
/// corner (d₁₂, d₂₃) twice and (d₃₄, d₄₁) never.)
class HoughPlane {
 public:
  void build(const HoughSpace& space, int angle);

  int bins() const { return bins_; }
  int alpha() const { return alpha_; }
  int toll() const { return toll_; }

  /// Weight of one bin: its occupied votes, or, where there are none, minus its free votes, scaled.
  int weight(int d, int p) const { return along_p(d, p + 1) - along_p(d, p); }
  /// Σ of weights (d, p') over p' < p, for 0 ≤ p ≤ bins.
  int along_p(int d, int p) const { return along_p_[at(d, p)]; }
  /// Σ of weights (d', p) over d' < d, for 0 ≤ d ≤ bins.
  int along_d(int d, int p) const { return along_d_[at(d, p)]; }
  /// Σ of interior votes over d1 < d' < d2 and p' < p.
  int interior(int d1, int d2, int p) const {
    return has_interior_ ? interior_[at(d2, p)] - interior_[at(d1 + 1, p)] : 0;
  }

  /// H_r of eq. 5–9, plus what `score: evidence` adds.
  int score(const BinRectangle& r) const;

 private:
  std::size_t at(int d, int p) const {
    return static_cast<std::size_t>(d) * static_cast<std::size_t>(bins_ + 1) + static_cast<std::size_t>(p);
  }
  void clear(const HoughSpace& space, int angle);
  void cast(const HoughSpace& space);
  void charge_for_free(double per_free);
  void accumulate();
  void accumulate_interior();

  int bins_ = 0;
  int alpha_ = 0;
  int toll_ = 0;
  bool has_interior_ = false;
  std::vector<int> along_p_, along_d_, interior_, free_;
};

}  // namespace enfilade::room_detector
