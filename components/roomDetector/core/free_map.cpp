// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/free_map.hpp"

#include <cmath>
#include <limits>

namespace enfilade::room_detector {
namespace {

std::int16_t clamped(int value) {
  return static_cast<std::int16_t>(std::clamp<int>(value, 0, std::numeric_limits<std::int16_t>::max()));
}

/// least[i] = min(least[i], other[i])
void lower(std::uint8_t* least, const std::uint8_t* other, int count) {
  for (int i = 0; i < count; ++i) least[i] = other[i] < least[i] ? other[i] : least[i];
}

}  // namespace

FreeMap::FreeMap(double cell_m, const Point2& origin, double reach_m) : cell_m_(cell_m) {
  const int reach = static_cast<int>(std::ceil(reach_m / cell_m)) + 4;
  first_x_ = static_cast<int>(std::floor(origin.x() / cell_m)) - reach;
  first_y_ = static_cast<int>(std::floor(origin.y() / cell_m)) - reach;
  blocks_ = (2 * reach >> kBlockBits) + 1;
  side_ = blocks_ << kBlockBits;
}

void FreeMap::allocate() {
  const auto cells = at(side_, 0), blocks = cells >> 2 * kBlockBits;
  free_ = ZeroedArray<std::int16_t>(cells);
  charge_ = ZeroedArray<std::int16_t>(cells);
  occupied_ = ZeroedArray<std::uint8_t>(cells);
  least_ = ZeroedArray<std::uint8_t>(blocks);
}

void FreeMap::set_rule(double per_free, int near_cells) {
  if (per_free == per_free_ && near_cells == near_cells_) return;
  per_free_ = per_free;
  near_cells_ = near_cells;
  for (int x = known_.from_x; x < known_.to_x; ++x) {
    for (int y = known_.from_y; y < known_.to_y; ++y) price(x, y);
  }
}

void FreeMap::add(const Point2& position, int free, int occupied) {
  const int x = static_cast<int>(std::floor(position.x() / cell_m_)) - first_x_,
            y = static_cast<int>(std::floor(position.y() / cell_m_)) - first_y_;
  if (!holds(x, y)) return;
  if (free_.empty()) allocate();
  known_.add({x, x + 1, y, y + 1});
  free_[at(x, y)] = clamped(free_[at(x, y)] + free);
  const bool was_occupied = occupied_[at(x, y)] > 0;
  occupied_[at(x, y)] = static_cast<std::uint8_t>(std::clamp(occupied_[at(x, y)] + occupied, 0, 255));
  if (per_free_ > 0.0) price_around(x, y, was_occupied != (occupied_[at(x, y)] > 0) ? near_cells_ : 0);
}

void FreeMap::price_around(int x, int y, int reach) {
  for (int i = std::max(0, x - reach); i <= std::min(side_ - 1, x + reach); ++i) {
    for (int j = std::max(0, y - reach); j <= std::min(side_ - 1, y + reach); ++j) price(i, j);
  }
}

void FreeMap::price(int x, int y) {
  const int free = free_[at(x, y)];
  std::int16_t& charge = charge_[at(x, y)];
  const std::int16_t before = charge;
  charge = free > 0 && !is_near_occupied(x, y) ? clamped(static_cast<int>(per_free_ * free + 0.5)) : 0;
  if (charge != before) changed_.add({x, x + 1, y, y + 1});
}

bool FreeMap::is_near_occupied(int x, int y) const {
  for (int i = std::max(0, x - near_cells_); i <= std::min(side_ - 1, x + near_cells_); ++i) {
    for (int j = std::max(0, y - near_cells_); j <= std::min(side_ - 1, y + near_cells_); ++j)
      if (occupied_[at(i, j)] > 0) return true;
  }
  return false;
}

double FreeMap::farthest_m(const Point2& p) const {
  if (known_.is_empty()) return 0.0;
  const auto away = [&](double at, int from, int to) {
    return std::max(std::abs(at / kOne - from), std::abs(at / kOne - to));
  };
  return cell_m_ * std::hypot(away(fixed_x(p.x()), known_.from_x, known_.to_x),
                              away(fixed_y(p.y()), known_.from_y, known_.to_y));
}

FreeMap::Least FreeMap::least_within(double distance_m) const {
  const double blocks = distance_m / cell_m_ / (1 << kBlockBits);
  const int reach = std::max(1, static_cast<int>(std::ceil(blocks)));
  update_least();
  const auto side = static_cast<std::size_t>(blocks_);
  if (reach >= kReaches) {
    if (nothing_.empty()) nothing_ = ZeroedArray<std::uint8_t>(side);
    return {nothing_.data(), 0};
  }
  Eroded& eroded = eroded_[static_cast<std::size_t>(reach)];
  if (eroded.reach != reach) eroded = {reach, blocks_of(known_), ZeroedArray<std::uint8_t>(side * side)};
  if (!eroded.stale.is_empty()) erode(eroded);
  return {eroded.charges.data(), static_cast<std::size_t>(blocks_)};
}

FreeMap::Box FreeMap::blocks_of(const Box& cells) {
  const int round_up = (1 << kBlockBits) - 1;
  return {cells.from_x >> kBlockBits, (cells.to_x + round_up) >> kBlockBits, cells.from_y >> kBlockBits,
          (cells.to_y + round_up) >> kBlockBits};
}

void FreeMap::update_least() const {
  if (changed_.is_empty()) return;
  const Box box = blocks_of(changed_);
  static_assert(kBlockBits == 1);
  std::vector<std::int16_t> lower_of_rows(static_cast<std::size_t>(2 * (box.to_y - box.from_y)));
  for (int x = box.from_x; x < box.to_x; ++x) {
    const std::int16_t *one = charge_.data() + at(2 * x, 2 * box.from_y), *other = one + side_;
    const auto count = static_cast<int>(lower_of_rows.size());
    std::int16_t* const lower = lower_of_rows.data();
    for (int i = 0; i < count; ++i) lower[i] = one[i] < other[i] ? one[i] : other[i];
    std::uint8_t* const least = least_.data() + block_at(x, box.from_y);
    for (int i = 0; i < count / 2; ++i) {
      const std::int16_t both = lower[2 * i] < lower[2 * i + 1] ? lower[2 * i] : lower[2 * i + 1];
      least[i] = static_cast<std::uint8_t>(both < 255 ? both : 255);
    }
  }
  for (Eroded& eroded : eroded_) eroded.stale.add(box);
  changed_ = {};
}

/// The least by rows first, then by columns.
void FreeMap::erode(Eroded& eroded) const {
  const int reach = eroded.reach;
  const Box box = eroded.stale.grown(reach, blocks_);
  const int from_x = std::max(0, box.from_x - reach), to_x = std::min(blocks_, box.to_x + reach);
  const auto width = static_cast<std::size_t>(box.to_y - box.from_y);
  by_row_.resize(static_cast<std::size_t>(to_x - from_x) * width);
  const auto row_of = [&](int x) { return by_row_.data() + static_cast<std::size_t>(x - from_x) * width; };
  for (int x = from_x; x < to_x; ++x) {
    std::fill_n(row_of(x), width, std::numeric_limits<std::uint8_t>::max());
    for (int k = -reach; k <= reach; ++k) {
      const int from = std::max(box.from_y, -k), to = std::min(box.to_y, blocks_ - k);
      lower(row_of(x) + (from - box.from_y), least_.data() + block_at(x, from + k), to - from);
    }
  }
  for (int x = box.from_x; x < box.to_x; ++x) {
    std::uint8_t* const least = eroded.charges.data() + block_at(x, box.from_y);
    std::copy_n(row_of(x), width, least);
    for (int i = std::max(from_x, x - reach); i < std::min(to_x, x + reach + 1); ++i)
      lower(least, row_of(i), static_cast<int>(width));
  }
  eroded.stale = {};
}

}  // namespace enfilade::room_detector
