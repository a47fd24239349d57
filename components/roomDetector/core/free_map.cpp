// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/free_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enfilade::room_detector {
namespace {

constexpr int kMost = std::numeric_limits<std::int16_t>::max();

std::int16_t clamped(int value) { return static_cast<std::int16_t>(std::clamp(value, 0, kMost)); }

/// out[i] = min of in[i - reach … i + reach] for i in [from, to); both advance by `stride`.
void slide_min(const std::int16_t* in, std::int16_t* out, int from, int to, int stride, int reach) {
  for (int i = from; i < to; ++i) {
    std::int16_t least = in[i * stride];
    for (int k = i - reach; k <= i + reach; ++k) least = std::min(least, in[k * stride]);
    out[i * stride] = least;
  }
}

}  // namespace

FreeMap::FreeMap(double cell_m, const Point2& origin, double reach_m) : cell_m_(cell_m) {
  const int reach = static_cast<int>(std::ceil(reach_m / cell_m)) + 4;
  first_x_ = static_cast<int>(std::floor(origin.x() / cell_m)) - reach;
  first_y_ = static_cast<int>(std::floor(origin.y() / cell_m)) - reach;
  blocks_ = (2 * reach >> kBlockBits) + 1;
  side_ = blocks_ << kBlockBits;
  low_block_ = blocks_;
}

void FreeMap::set_rule(double per_free, int near_cells) {
  if (per_free == per_free_ && near_cells == near_cells_) return;
  per_free_ = per_free;
  near_cells_ = near_cells;
  eroded_reach_ = -1;
  if (free_.empty()) return;
  for (int x = 0; x < side_; ++x) {
    for (int y = 0; y < side_; ++y) price(x, y);
  }
}

void FreeMap::add(const Point2& position, int free, int occupied) {
  const int x = static_cast<int>(std::floor(position.x() / cell_m_)) - first_x_,
            y = static_cast<int>(std::floor(position.y() / cell_m_)) - first_y_;
  if (!holds(x, y)) return;
  if (free_.empty()) {
    free_.assign(at(side_, 0), 0);
    occupied_ = charge_ = free_;
    least_.assign(static_cast<std::size_t>(blocks_) * static_cast<std::size_t>(blocks_), 0);
  }
  free_[at(x, y)] = clamped(free_[at(x, y)] + free);
  occupied_[at(x, y)] = clamped(occupied_[at(x, y)] + occupied);
  if (per_free_ > 0.0) price_around(x, y, occupied != 0 ? near_cells_ : 0);
}

void FreeMap::price_around(int x, int y, int reach) {
  for (int i = std::max(0, x - reach); i <= std::min(side_ - 1, x + reach); ++i) {
    for (int j = std::max(0, y - reach); j <= std::min(side_ - 1, y + reach); ++j) price(i, j);
  }
}

void FreeMap::price(int x, int y) {
  std::int16_t& charge = charge_[at(x, y)];
  const std::int16_t before = charge;
  charge = 0;
  if (free_[at(x, y)] > 0) {
    bool is_near = false;
    for (int i = std::max(0, x - near_cells_); i <= std::min(side_ - 1, x + near_cells_); ++i) {
      for (int j = std::max(0, y - near_cells_); j <= std::min(side_ - 1, y + near_cells_); ++j)
        is_near |= occupied_[at(i, j)] > 0;
    }
    if (!is_near) charge = clamped(static_cast<int>(std::lround(per_free_ * free_[at(x, y)])));
  }
  if (charge != before) note_change(x, y);
}

void FreeMap::note_change(int x, int y) {
  const int bx = x >> kBlockBits, by = y >> kBlockBits, size = 1 << kBlockBits;
  std::int16_t least = static_cast<std::int16_t>(kMost);
  for (int i = bx * size; i < (bx + 1) * size; ++i) {
    for (int j = by * size; j < (by + 1) * size; ++j) least = std::min(least, charge_[at(i, j)]);
  }
  std::int16_t& known =
      least_[static_cast<std::size_t>(bx) * static_cast<std::size_t>(blocks_) + static_cast<std::size_t>(by)];
  if (known == least) return;
  known = least;
  low_block_ = std::min({low_block_, bx, by});
  high_block_ = std::max({high_block_, bx, by});
  eroded_reach_ = -1;
}

void FreeMap::erode(double radius_m) const {
  const int reach = static_cast<int>(std::ceil(radius_m / cell_m_ / (1 << kBlockBits)));
  if (reach == eroded_reach_ || charge_.empty()) return;
  const auto blocks = static_cast<std::size_t>(blocks_);
  std::vector<std::int16_t> by_row(least_.size(), 0);
  eroded_.assign(least_.size(), 0);
  const int from = std::max(reach, low_block_), to = std::min(blocks_ - reach, high_block_ + 1);
  for (int x = low_block_; x <= high_block_; ++x)
    slide_min(&least_[static_cast<std::size_t>(x) * blocks], &by_row[static_cast<std::size_t>(x) * blocks],
              from, to, 1, reach);
  for (int y = from; y < to; ++y)
    slide_min(&by_row[static_cast<std::size_t>(y)], &eroded_[static_cast<std::size_t>(y)], from, to, blocks_,
              reach);
  eroded_reach_ = reach;
}

}  // namespace enfilade::room_detector
