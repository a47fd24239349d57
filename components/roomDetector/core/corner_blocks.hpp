// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "components/roomDetector/core/best_window.hpp"
#include "components/roomDetector/core/corner_choice.hpp"

namespace enfilade::room_detector {

/// The most that the corner terms of eq. 5 come to, by blocks of lines, and what follows for rectangles: four
/// corners whose lines meet.
///
/// Values are held in 16 bits, in units of 2^scale_bits and rounded up.
class CornerBlocks {
 public:
  /// All corners stay below 2^(14 + scale_bits), so that two of them add up in 16 bits.
  void lay_out(const LineBlocks& blocks, int scale_bits);
  /// Takes all corners for worse than any.
  void clear();
  void set(int d_side, int p_side, int d_block, int p_block, int most) {
    const int rounded = (most + (1 << scale_bits_) - 1) >> scale_bits_;
    corners_[d_side][p_side][index(d_block, p_block)] =
        static_cast<std::int16_t>(rounded > kLeast ? rounded : kLeast);
  }

  /// d₁₂ of block `first` with d₃₄ of block `second`: no rectangle there scores more than `bound`.
  struct Pair {
    int bound, first, second;
  };
  /// Finds every pair that may hold `score` with sides within the limits, and all their corners.
  void solve(int score, const WindowLimits& d, const WindowLimits& p);
  const std::vector<Pair>& pairs() const { return pairs_; }
  const CornerChoice& choice() const { return choice_; }
  /// Of all pairs; kNever where there are none.
  int bound() const { return bound_; }
  /// The corners of the best four blocks.
  CornerChoice best() const;

  /// The blocks of d₄₁ and of d₂₃ that may belong to a rectangle of the pair with `score`.
  struct Across {
    int bound = kNever;
    std::vector<int> d41, d23;
    int best_d41 = 0, best_d23 = 0;
  };
  const Across& across(int first, int second, int score, const WindowLimits& p);

 private:
  static constexpr int kLeast = -(1 << 13);
  static constexpr int kLanes = 8;

  using Values = std::vector<std::int16_t>;
  int blocks(int side) const { return choice_.count(side); }
  std::size_t index(int d_block, int p_block) const {
    return static_cast<std::size_t>(d_block * width_ + p_block);
  }
  int least(int score) const { return (score + (1 << scale_bits_) - 1) >> scale_bits_; }
  void bound_sides();
  int add_up(int p_side, int first, int second, Values& sums) const;
  void solve_pair(int first, int second, int score, const WindowLimits& p);

  CornerChoice choice_;
  int scale_bits_ = 0, width_ = 0;
  std::array<std::array<Values, 2>, 2> corners_;  // by side of d and of p
  std::array<std::vector<int>, 2> most_;          // by side of d: of its blocks
  Values of_d41_, of_d23_;
  std::vector<std::uint8_t> is_needed_;
  std::vector<Pair> pairs_;
  std::array<int, 4> best_{};
  int bound_ = kNever;
  Across across_;
};

}  // namespace enfilade::room_detector
