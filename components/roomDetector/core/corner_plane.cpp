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

void CornerPlane::build(const HoughSpace& space, int angle, const HoughSpace::Bins& robot,
                        const Reaches& reaches) {
  alpha_ = angle;
  toll_ = space.penalties().per_bin;
  margin_ = space.penalties().contour_bins;
  cast(space, robot, reaches);
  if (space.free_map().charges()) charge(space);
  accumulate();
  column_p_.clear();
  for (int c = 0; c < columns_; ++c) {
    if (c == robot_column_) behind_ = column_p_.size();
    if (c != robot_column_) column_p_.push_back(first_p_ + c);
  }
  fill(left_, 0, robot_row_, true);
  fill(right_, robot_row_ + 1, rows_, false);
}

void CornerPlane::cast(const HoughSpace& space, const HoughSpace::Bins& robot, const Reaches& reaches) {
  rows_ = reaches.d12 + 1 + reaches.d34;
  columns_ = reaches.d41 + 1 + reaches.d23;
  robot_row_ = reaches.d12;
  robot_column_ = reaches.d41;
  first_d_ = robot.d - reaches.d12;
  first_p_ = robot.p - reaches.d41;
  const auto size = static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_);
  weight_.assign(size, 0);
  has_interior_ = false;
  for (const HoughSpace::WallVote& vote : space.wall_votes()) {
    const HoughSpace::Bins b = space.bins_at(alpha_, vote.x_m, vote.y_m);
    const int row = b.d - first_d_, column = b.p - first_p_;
    if (row < 0 || column < 0 || row >= rows_ || column >= columns_) continue;
    const std::size_t i =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    weight_[i] += vote.occupied;
    if (vote.interior == 0) continue;
    if (!has_interior_)
      interior_.assign(static_cast<std::size_t>(rows_ + 1) * static_cast<std::size_t>(columns_ + 1), 0);
    has_interior_ = true;
    interior_[i + static_cast<std::size_t>(row)] += vote.interior;
  }
}

void CornerPlane::charge(const HoughSpace& space) {
  const HoughSpace::BinCentres centres = space.bin_centres(alpha_);
  const FreeMap& free = space.free_map();
  int* weight = weight_.data();
  for (int row = 0; row < rows_; ++row) {
    std::int32_t x = centres.x_at(first_d_ + row, first_p_), y = centres.y_at(first_d_ + row, first_p_);
    for (int c = 0; c < columns_; ++c, x -= centres.y_by_d, y += centres.x_by_d)
      *weight++ -= free.charge_at(x, y);
  }
}

/// Sums up along p, along d, and over areas: each entry holds what lies before it.
void CornerPlane::accumulate() {
  const auto width = static_cast<std::size_t>(columns_ + 1);
  const auto size = static_cast<std::size_t>(rows_ + 1) * width;
  along_p_.resize(size);
  along_d_.resize(size);
  std::fill_n(along_d_.begin(), width, 0);
  for (int r = 0; r < rows_; ++r) {
    const int* weight = weight_.data() + static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_);
    const std::size_t row = static_cast<std::size_t>(r) * width;
    int sum = 0;
    for (std::size_t c = 0; c < width - 1; ++c) {
      along_p_[row + c] = sum;
      sum += weight[c];
    }
    along_p_[row + width - 1] = sum;
    for (std::size_t c = 0; c < width - 1; ++c) along_d_[row + width + c] = along_d_[row + c] + weight[c];
  }
  if (!has_interior_) return;
  std::vector<int> above(width, 0);
  for (int r = 0; r <= rows_; ++r) {
    int* row = interior_.data() + static_cast<std::size_t>(r) * width;
    int sum = 0;
    for (std::size_t c = 0; c < width; ++c) {
      const int vote = row[c];
      row[c] = sum;
      sum += above[c];
      above[c] += vote;
    }
  }
}

int CornerPlane::interior_at(int d, int p) const {
  if (!has_interior_) return 0;
  return interior_[static_cast<std::size_t>(std::clamp(d, 0, rows_)) *
                       static_cast<std::size_t>(columns_ + 1) +
                   static_cast<std::size_t>(std::clamp(p, 0, columns_))];
}

/// The terms of eq. 5 that belong to the corners on the lines from ≤ d < to: two half walls, their tolls and
/// the interior up to the robot's bin.
void CornerPlane::fill(Corners& corners, int from, int to, bool is_first) {
  const auto width = static_cast<std::size_t>(columns_ + 1), count = column_p_.size();
  const auto rd = static_cast<std::size_t>(robot_row_), rp = static_cast<std::size_t>(robot_column_);
  corners.lines.clear();
  corners.terms.resize(static_cast<std::size_t>(to - from) * count);
  for (int d = from; d < to; ++d) {
    corners.lines.push_back(first_d_ + d);
    int* term = corners.terms.data() + static_cast<std::size_t>(d - from) * count;
    const auto row = static_cast<std::size_t>(d) * width;
    const int* p_of = along_p_.data() + row;
    const int* d_of = along_d_.data() + row;
    const int *d_robot = along_d_.data() + rd * width, *after = d_robot + width;
    const int away = toll_ * (is_first ? robot_row_ - d : d - robot_row_);
    for (std::size_t p = 0; p < rp; ++p) {  // d₄₁ = p
      const int half_d = is_first ? p_of[rp] - p_of[p] : p_of[rp + 1] - p_of[p + 1];
      const int half_p = is_first ? after[p] - d_of[width + p] : d_of[width + p] - after[p];
      term[p] = half_d + half_p - away - toll_ * static_cast<int>(rp - p);
    }
    for (std::size_t p = rp + 1; p + 1 < width; ++p) {  // d₂₃ = p
      const int half_d = is_first ? p_of[p] - p_of[rp] : p_of[p + 1] - p_of[rp + 1];
      const int half_p = is_first ? d_robot[p] - d_of[p] : d_of[p] - d_robot[p];
      term[p - 1] = half_d + half_p - away - toll_ * static_cast<int>(p - rp);
    }
    if (!has_interior_) continue;
    const int edge = is_first ? d + 1 + margin_ : d - margin_, sign = is_first ? 1 : -1;
    for (int p = 0; p < robot_column_; ++p)
      term[p] -= sign * (interior_at(robot_row_, robot_column_) - interior_at(edge, robot_column_) -
                         interior_at(robot_row_, p + 1 + margin_) + interior_at(edge, p + 1 + margin_));
    for (int p = robot_column_ + 1; p < columns_; ++p)
      term[p - 1] -= sign * (interior_at(robot_row_, p - margin_) - interior_at(edge, p - margin_) -
                             interior_at(robot_row_, robot_column_) + interior_at(edge, robot_column_));
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

int CornerPlane::bound_of_pair(std::size_t first, std::size_t second) const {
  const std::size_t count = column_p_.size();
  const int *a = left_.terms.data() + first * count, *b = right_.terms.data() + second * count;
  return most_of_sum(a, b, behind_) + most_of_sum(a + behind_, b + behind_, count - behind_);
}

void CornerPlane::search(const PlaneLimits& limits, Incumbent& best) {
  for (bool drops = true; drops;) {
    drops = drop_rows(best.score);
    if (left_.lines.empty() || right_.lines.empty()) return;
    drops = drop_columns(best.score) && drops;
    if (behind_ == 0 || behind_ == column_p_.size()) return;
  }
  bound_rows(left_);
  bound_rows(right_);
  const auto order_of = [](const Corners& corners) {
    std::vector<std::size_t> order(corners.lines.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return corners.most[a] > corners.most[b]; });
    return order;
  };
  const auto lefts = order_of(left_), rights = order_of(right_);
  for (const std::size_t i : lefts) {
    if (left_.most[i] + right_.most[rights.front()] < best.score) break;
    for (const std::size_t l : rights) {
      const int bound = left_.most[i] + right_.most[l];
      if (bound < best.score) break;
      const int gap = right_.lines[l] - left_.lines[i];
      if (gap < limits.d.min_gap || gap > limits.d.max_gap) continue;
      const BinRectangle first{alpha_, left_.lines[i], right_.lines[l], 0, 0};
      if (!best.may_lose_to(bound, first)) continue;
      if (!best.has_budget()) {
        best.gap_bound = std::max(best.gap_bound, bound);
        return;
      }
      ++best.expansions;
      if (!best.may_lose_to(bound_of_pair(i, l), first)) continue;
      best.expansions += 4;
      solve_pair(i, l, limits, best);
    }
  }
}

void CornerPlane::solve_pair(std::size_t first, std::size_t second, const PlaneLimits& limits,
                             Incumbent& best) {
  const std::size_t count = column_p_.size();
  const int *a = left_.terms.data() + first * count, *b = right_.terms.data() + second * count;
  // Lines of p that were dropped stay between those that were not, for the distances to be right.
  const int from = column_p_.front(), bins = column_p_.back() - from + 1;
  std::vector<int> sums(static_cast<std::size_t>(bins), kNever);
  for (std::size_t c = 0; c < count; ++c) sums[static_cast<std::size_t>(column_p_[c] - from)] = a[c] + b[c];
  WindowLimits of_p = limits.p;
  of_p.last_first -= from;
  of_p.first_second -= from;
  const auto sum = [&](int p) { return sums[static_cast<std::size_t>(p)]; };
  const Window found = best_window(bins, of_p, sum, sum);
  if (found.first < 0) return;
  best.offer({alpha_, left_.lines[first], right_.lines[second], found.first + from, found.second + from},
             found.value);
}

}  // namespace enfilade::room_detector
