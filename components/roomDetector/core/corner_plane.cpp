// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/corner_plane.hpp"

#include <algorithm>
#include <numeric>

namespace enfilade::room_detector {
namespace {

int most_of(const int* from, const int* to) {
  int most = kNever;
  for (; from < to; ++from) most = *from > most ? *from : most;
  return most;
}

int most_of_sum(const int* a, const int* b, std::size_t count) {
  int most = kNever;
  for (std::size_t i = 0; i < count; ++i) most = a[i] + b[i] > most ? a[i] + b[i] : most;
  return most;
}

}  // namespace

void CornerPlane::build(const HoughSpace& space, const NearVotes& votes, int angle,
                        const HoughSpace::Bins& robot, const CornerChoice& choice) {
  alpha_ = angle;
  robot_ = robot;
  scale_bits_ = votes.scale_bits();
  corner_lines_.build(space, votes, angle, robot, choice);
  column_p_ = corner_lines_.lines(1);
  behind_ = static_cast<std::size_t>(corner_lines_.before(1));
  const int middle = corner_lines_.before(0), end = static_cast<int>(corner_lines_.lines(0).size());
  for (Corners* corners : {&left_, &right_}) {
    const int from = corners == &left_ ? 0 : middle, to = corners == &left_ ? middle : end;
    const auto& d = corner_lines_.lines(0);
    corners->lines.assign(d.begin() + from, d.begin() + to);
    corners->terms.resize(corners->lines.size() * column_p_.size());
    for (int line = from; line < to; ++line)
      corner_lines_.fill(line,
                         corners->terms.data() + static_cast<std::size_t>(line - from) * column_p_.size());
  }
}

void CornerPlane::bound_rows(Corners& corners) const {
  const std::size_t count = column_p_.size();
  corners.most.resize(corners.lines.size());
  for (std::size_t r = 0; r < corners.lines.size(); ++r) {
    const int* row = corners.terms.data() + r * count;
    corners.most[r] = most_of(row, row + behind_) + most_of(row + behind_, row + count);
  }
}

/// Drops the lines of d that cannot be part of `score`, whatever the other three are. Whether any was.
bool CornerPlane::drop_rows(int score) {
  bound_rows(left_);
  bound_rows(right_);
  const auto most = [](const Corners& c) { return most_of(c.most.data(), c.most.data() + c.most.size()); };
  const int of_left = most(left_), of_right = most(right_);
  bool dropped = false;
  for (Corners* corners : {&left_, &right_}) {
    const int other = corners == &left_ ? of_right : of_left;
    const std::size_t count = column_p_.size();
    std::size_t kept = 0;
    for (std::size_t r = 0; r < corners->lines.size(); ++r) {
      if (corners->most[r] + other < score) continue;
      if (kept != r)
        std::copy_n(corners->terms.begin() + r * count, count, corners->terms.begin() + kept * count);
      corners->lines[kept] = corners->lines[r];
      corners->most[kept++] = corners->most[r];
    }
    dropped |= kept < corners->lines.size();
    corners->lines.resize(kept);
    corners->most.resize(kept);
  }
  return dropped;
}

/// The same for the lines of p.
bool CornerPlane::drop_columns(int score) {
  const std::size_t count = column_p_.size();
  std::vector<int> most(count, 0), of_side(count);
  for (const Corners* corners : {&left_, &right_}) {
    std::fill(of_side.begin(), of_side.end(), kNever);
    for (std::size_t r = 0; r < corners->lines.size(); ++r) {
      const int* row = corners->terms.data() + r * count;
      for (std::size_t c = 0; c < count; ++c) of_side[c] = row[c] > of_side[c] ? row[c] : of_side[c];
    }
    for (std::size_t c = 0; c < count; ++c) most[c] += of_side[c];
  }
  const int before = most_of(most.data(), most.data() + behind_),
            behind = most_of(most.data() + behind_, most.data() + count);
  std::vector<std::size_t> kept;
  for (std::size_t c = 0; c < count; ++c) {
    if (most[c] + (c < behind_ ? behind : before) >= score) kept.push_back(c);
  }
  if (kept.size() == count) return false;
  keep_columns(left_, kept);
  keep_columns(right_, kept);
  behind_ = static_cast<std::size_t>(std::lower_bound(kept.begin(), kept.end(), behind_) - kept.begin());
  for (std::size_t c = 0; c < kept.size(); ++c) column_p_[c] = column_p_[kept[c]];
  column_p_.resize(kept.size());
  return true;
}

void CornerPlane::keep_columns(Corners& corners, const std::vector<std::size_t>& kept) const {
  const std::size_t count = column_p_.size();
  int* to = corners.terms.data();
  for (std::size_t r = 0; r < corners.lines.size(); ++r) {
    const int* row = corners.terms.data() + r * count;
    for (const std::size_t c : kept) *to++ = row[c];
  }
}

/// Whether any are left.
bool CornerPlane::drop_lines(int score) {
  for (bool drops = true; drops;) {
    drops = drop_rows(score);
    if (left_.lines.empty() || right_.lines.empty()) return false;
    drops = drop_columns(score) && drops;
    if (behind_ == 0 || behind_ == column_p_.size()) return false;
  }
  return true;
}

/// By side: outward from the robot, up to kBlock rows or columns each.
void CornerPlane::lay_out_blocks() {
  std::array<std::vector<LineBlock>, 4> sides;
  const auto add = [&](int side, std::size_t from, std::size_t to, const auto& lines, int robot) {
    ranges_[side].push_back({from, to});
    const int a = std::abs(lines[from] - robot), b = std::abs(lines[to - 1] - robot);
    sides[side].push_back({std::min(a, b), std::max(a, b)});
  };
  const auto cut = [&](int side, std::size_t from, std::size_t to, const auto& lines, int robot) {
    ranges_[side].clear();
    for (std::size_t i = from; i < to; i += CornerBounds::kBlock)
      add(side, i, std::min(to, i + CornerBounds::kBlock), lines, robot);
  };
  cut(kD12, 0, left_.lines.size(), left_.lines, robot_.d);
  cut(kD34, 0, right_.lines.size(), right_.lines, robot_.d);
  cut(kD41, 0, behind_, column_p_, robot_.p);
  cut(kD23, behind_, column_p_.size(), column_p_, robot_.p);
  blocks_.lay_out(sides, scale_bits_ + 1);
}

void CornerPlane::fill_blocks() {
  const std::size_t count = column_p_.size();
  std::vector<int> most(count);
  for (int d = 0; d < 2; ++d) {
    const Corners& corners = d ? right_ : left_;
    for (std::size_t m = 0; m < ranges_[d].size(); ++m) {
      std::fill(most.begin(), most.end(), kNever);
      for (std::size_t r = ranges_[d][m].from; r < ranges_[d][m].to; ++r) {
        const int* row = corners.terms.data() + r * count;
        for (std::size_t c = 0; c < count; ++c) most[c] = row[c] > most[c] ? row[c] : most[c];
      }
      for (int p = 0; p < 2; ++p) {
        const auto& columns = ranges_[kD41 + p];
        for (std::size_t n = 0; n < columns.size(); ++n)
          blocks_.set(d, p, static_cast<int>(m), static_cast<int>(n),
                      most_of(most.data() + columns[n].from, most.data() + columns[n].to));
      }
    }
  }
}

void CornerPlane::search(const PlaneLimits& limits, Incumbent& best) {
  if (left_.lines.empty() || right_.lines.empty() || column_p_.empty() || !drop_lines(best.score)) return;
  lay_out_blocks();
  fill_blocks();
  blocks_.solve(best.score, limits.d, limits.p);
  auto pairs = blocks_.pairs();
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& a, const auto& b) { return a.bound > b.bound; });
  for (const CornerBlocks::Pair& pair : pairs) {
    if (pair.bound < best.score) break;
    if (!best.has_budget()) {
      best.gap_bound = std::max(best.gap_bound, pair.bound);
      return;
    }
    search_blocks(pair, limits, best);
  }
}

void CornerPlane::search_blocks(const CornerBlocks::Pair& pair, const PlaneLimits& limits, Incumbent& best) {
  const auto& across = blocks_.across(pair.first, pair.second, best.score, limits.p);
  if (across.bound < best.score) return;
  before_.clear();
  after_.clear();
  for (const int j : across.d41) before_.push_back(ranges_[kD41][j]);
  for (const int k : across.d23) after_.push_back(ranges_[kD23][k]);
  const Range lefts = ranges_[kD12][pair.first], rights = ranges_[kD34][pair.second];
  const std::size_t count = column_p_.size();
  for (std::size_t i = lefts.from; i < lefts.to; ++i) {
    for (std::size_t l = rights.from; l < rights.to; ++l) {
      const int gap = right_.lines[l] - left_.lines[i];
      if (gap < limits.d.min_gap || gap > limits.d.max_gap) continue;
      const int bound = bound_of_lines(left_.terms.data() + i * count, right_.terms.data() + l * count);
      if (!best.may_lose_to(bound, {alpha_, left_.lines[i], right_.lines[l], 0, 0})) continue;
      best.expansions += 1 + static_cast<int>(column_p_.size() / 128);
      solve_pair(i, l, limits, best);
    }
  }
  best.expansions += 1 + static_cast<int>((lefts.to - lefts.from) * (rights.to - rights.from)) / 16;
}

int CornerPlane::bound_of_lines(const int* a, const int* b) const {
  int d41 = kNever, d23 = kNever;
  for (const Range& r : before_) d41 = std::max(d41, most_of_sum(a + r.from, b + r.from, r.to - r.from));
  for (const Range& r : after_) d23 = std::max(d23, most_of_sum(a + r.from, b + r.from, r.to - r.from));
  return d41 + d23;
}

void CornerPlane::solve_pair(std::size_t first, std::size_t second, const PlaneLimits& limits,
                             Incumbent& best) {
  const std::size_t count = column_p_.size();
  const int *a = left_.terms.data() + first * count, *b = right_.terms.data() + second * count;
  // Lines of p that were dropped stay between those that were not, for the distances to be right.
  const int from = column_p_.front(), bins = column_p_.back() - from + 1;
  sums_.assign(static_cast<std::size_t>(bins), kNever);
  for (std::size_t c = 0; c < count; ++c) sums_[static_cast<std::size_t>(column_p_[c] - from)] = a[c] + b[c];
  WindowLimits of_p = limits.p;
  of_p.last_first -= from;
  of_p.first_second -= from;
  const auto sum = [&](int p) { return sums_[static_cast<std::size_t>(p)]; };
  const Window found = best_window(bins, of_p, sum, sum);
  if (found.first < 0) return;
  best.offer({alpha_, left_.lines[first], right_.lines[second], found.first + from, found.second + from},
             found.value);
}

}  // namespace enfilade::room_detector
