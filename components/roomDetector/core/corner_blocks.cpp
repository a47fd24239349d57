// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/corner_blocks.hpp"

#include <algorithm>

namespace enfilade::room_detector {
namespace {

using Value = std::int16_t;

int most_of_row(const Value* values, int count) {
  Value most = std::numeric_limits<Value>::min();
  for (int i = 0; i < count; ++i) most = values[i] > most ? values[i] : most;
  return most;
}

bool may_fit(const LineBlock& a, const LineBlock& b, const WindowLimits& limits) {
  return a.farthest + b.farthest >= limits.min_gap && a.nearest + b.nearest <= limits.max_gap;
}

}  // namespace

void CornerBlocks::lay_out(const LineBlocks& blocks, int scale_bits) {
  choice_ = CornerChoice::all(blocks);
  scale_bits_ = scale_bits;
  const std::size_t most = std::max(blocks[kD41].size(), blocks[kD23].size());
  width_ = (static_cast<int>(most) + kLanes - 1) / kLanes * kLanes;
  of_d41_.resize(static_cast<std::size_t>(width_));
  of_d23_.resize(static_cast<std::size_t>(width_));
  clear();
}

void CornerBlocks::clear() {
  for (int d = 0; d < 2; ++d) {
    for (auto& corners : corners_[d])
      corners.assign(static_cast<std::size_t>(blocks(d) * width_), static_cast<Value>(kLeast));
  }
}

void CornerBlocks::bound_sides() {
  for (int d = 0; d < 2; ++d) {
    most_[d].resize(choice_.blocks[d].size());
    for (int m = 0; m < blocks(d); ++m)
      most_[d][m] = most_of_row(corners_[d][0].data() + index(m, 0), width_) +
                    most_of_row(corners_[d][1].data() + index(m, 0), width_);
  }
}

/// The sums of the corners of two blocks of d, and the largest of them.
int CornerBlocks::add_up(int p_side, int first, int second, Values& sums) const {
  const Value *a = corners_[0][p_side].data() + index(first, 0),
              *b = corners_[1][p_side].data() + index(second, 0);
  Value* const out = sums.data();
  Value most = std::numeric_limits<Value>::min();
  for (int n = 0; n < width_; ++n) {
    out[n] = static_cast<Value>(a[n] + b[n]);
    most = out[n] > most ? out[n] : most;
  }
  return most;
}

void CornerBlocks::solve(int score, const WindowLimits& d, const WindowLimits& p) {
  pairs_.clear();
  bound_ = kNever;
  choice_.clear();
  if (blocks(kD12) == 0 || blocks(kD34) == 0) return;
  bound_sides();
  const int best_second = *std::max_element(most_[kD34].begin(), most_[kD34].end());
  for (int i = 0; i < blocks(kD12); ++i) {
    if (most_[kD12][i] + best_second < least(score)) continue;
    for (int l = 0; l < blocks(kD34); ++l) {
      if (most_[kD12][i] + most_[kD34][l] < least(score)) continue;
      if (may_fit(choice_.blocks[kD12][i], choice_.blocks[kD34][l], d)) solve_pair(i, l, score, p);
    }
  }
}

void CornerBlocks::solve_pair(int first, int second, int score, const WindowLimits& p) {
  across(first, second, score, p);
  if (across_.bound < score) return;
  pairs_.push_back({across_.bound, first, second});
  for (const int j : across_.d41) choice_.add(0, first, second, j);
  for (const int k : across_.d23) choice_.add(1, first, second, k);
  if (across_.bound <= bound_) return;
  bound_ = across_.bound;
  best_ = {first, second, across_.best_d41, across_.best_d23};
}

const CornerBlocks::Across& CornerBlocks::across(int first, int second, int score, const WindowLimits& p) {
  across_.bound = kNever;
  across_.d41.clear();
  across_.d23.clear();
  const int most_d41 = add_up(0, first, second, of_d41_), most_d23 = add_up(1, first, second, of_d23_);
  const int enough = least(score);
  if (most_d41 + most_d23 < enough) return across_;
  for (int k = 0; k < blocks(kD23); ++k) {
    if (of_d23_[k] + most_d41 >= enough) across_.d23.push_back(k);
  }
  is_needed_.assign(choice_.blocks[kD23].size(), 0);
  int best = kNever;
  for (int j = 0; j < blocks(kD41); ++j) {
    if (of_d41_[j] + most_d23 < enough) continue;
    bool is_part = false;
    for (const int k : across_.d23) {
      const int sum = of_d41_[j] + of_d23_[k];
      if (sum < enough || !may_fit(choice_.blocks[kD41][j], choice_.blocks[kD23][k], p)) continue;
      is_part = true;
      is_needed_[k] = 1;
      if (sum <= best) continue;
      best = sum;
      across_.best_d41 = j;
      across_.best_d23 = k;
    }
    if (is_part) across_.d41.push_back(j);
  }
  std::erase_if(across_.d23, [&](int k) { return !is_needed_[k]; });
  if (best > kNever) across_.bound = best * (1 << scale_bits_);
  return across_;
}

CornerChoice CornerBlocks::best() const {
  LineBlocks blocks;
  for (int s = 0; s < 4; ++s) blocks[s] = {choice_.blocks[s][best_[s]]};
  return CornerChoice::all(std::move(blocks));
}

}  // namespace enfilade::room_detector
