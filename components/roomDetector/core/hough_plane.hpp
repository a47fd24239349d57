// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
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

  /// Weight of one bin: its occupied votes less what free space there costs.
  int weight(int d, int p) const { return along_p(d, p + 1) - along_p(d, p); }
  /// Σ of weights (d, p') over p' < p, for 0 ≤ p ≤ bins.
  int along_p(int d, int p) const { return along_p_[at(d, p)]; }
  /// Σ of weights (d', p) over d' < d, for 0 ≤ d ≤ bins.
  int along_d(int d, int p) const { return along_d_[at(d, p)]; }
  /// The interior votes of a rectangle, less those at its contour, are interior_below(d12, d34, d23) −
  /// interior_above(d12, d34, d41).
  int interior_below(int d12, int d34, int d23) const { return interior(d12, d34, d23 - margin_); }
  int interior_above(int d12, int d34, int d41) const { return interior(d12, d34, d41 + 1 + margin_); }

  /// H_r of eq. 5–9, plus what `score: evidence` adds.
  int score(const BinRectangle& r) const;

 private:
  std::size_t at(int d, int p) const {
    return static_cast<std::size_t>(d) * static_cast<std::size_t>(bins_ + 1) + static_cast<std::size_t>(p);
  }
  /// Σ of interior votes over d12 + margin < d' < d34 - margin and p' < p.
  int interior(int d12, int d34, int p) const {
    if (!has_interior_ || d34 - d12 <= 2 * margin_) return 0;
    p = std::clamp(p, 0, bins_);
    return interior_[at(d34 - margin_, p)] - interior_[at(d12 + 1 + margin_, p)];
  }
  void clear(const HoughSpace& space, int angle);
  void cast(const HoughSpace& space);
  void charge(const HoughSpace& space);
  void accumulate();
  void accumulate_interior();

  int bins_ = 0;
  int alpha_ = 0;
  int toll_ = 0;
  int margin_ = 0;
  bool has_interior_ = false;
  std::vector<int> along_p_, along_d_, interior_;
};

}  // namespace enfilade::room_detector
