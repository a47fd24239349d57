// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "components/roomDetector/core/hough_space.hpp"

namespace enfilade::room_detector {

/// The wall votes that any rectangle around the robot can have on its contour or inside, nearest first, laid
/// out for going through them once for each angle.
class NearVotes {
 public:
  /// Keeps those at most `reach_bins` bins from the robot's along each axis of any plane. No line of any
  /// plane holds more than `most_of_line`.
  void gather(const HoughSpace& space, const Point2& robot, int reach_bins, int most_of_line);

  int size() const { return static_cast<int>(x_m_.size()); }
  int scale_bits() const { return scale_bits_; }
  /// Whether the scaled votes of any line add up to less than 2^15. So they do, unless bins hold hundreds of
  /// cells with many votes.
  bool fit_strips() const { return fit_strips_; }
  /// Whether any of them speaks against an interior.
  bool speak_against() const { return speak_against_; }
  /// How many come before the first that is farther than this from the robot's bin in every plane.
  int count_within(double bins) const;
  /// In no plane any vote is more bins away from the robot's, along either axis.
  int farthest_bins() const { return farthest_bins_; }

  /// Some of the votes, with their bins in a plane.
  struct Chunk {
    const int *d, *p;
    const std::int16_t* scaled;  ///< occupied in units of 2^scale_bits, rounded up
    const int *occupied, *interior;
    int size;
  };
  /// Calls visit(chunk) until it has seen the nearest `size` votes.
  template <class Visit>
  void for_each_chunk(const HoughSpace::Binning& binning, int size, Visit visit) const {
    constexpr int kChunk = 256;
    int d[kChunk], p[kChunk];
    for (int from = 0; from < size; from += kChunk) {
      const int count = std::min(kChunk, size - from);
      const double *x = x_m_.data() + from, *y = y_m_.data() + from;
      for (int i = 0; i < count; ++i) d[i] = binning.d(x[i], y[i]);
      for (int i = 0; i < count; ++i) p[i] = binning.p(x[i], y[i]);
      visit(Chunk{d, p, scaled_.data() + from, occupied_.data() + from, interior_.data() + from, count});
    }
  }

 private:
  void choose_scale(const HoughSpace& space, int reach_bins, int most_of_line);
  void sort(const std::vector<HoughSpace::WallVote>& votes, int rings);

  static constexpr int kRing_bins = 8;

  std::vector<double> x_m_, y_m_;  // from the origin of the space
  std::vector<std::int16_t> scaled_;
  std::vector<int> occupied_, interior_;
  std::vector<int> before_ring_;  // votes nearer than ring i
  std::vector<int> ring_of_;
  int farthest_bins_ = 0;
  int scale_bits_ = 0;
  bool fit_strips_ = true, speak_against_ = false;
};

}  // namespace enfilade::room_detector
