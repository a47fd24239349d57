// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/hit_map.hpp"

#include <cmath>

namespace enfilade::room_detector {
namespace {

constexpr int kAxisBits = 20;
constexpr std::uint64_t kAxisMask = (1u << kAxisBits) - 1;
constexpr double kMostDistant_m = 1000.0;

std::uint64_t axis_index(double metres, double resolution_m) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(metres / resolution_m))) & kAxisMask;
}

bool is_usable(const CellHit& hit) {
  return std::abs(hit.x_m) < kMostDistant_m && std::abs(hit.y_m) < kMostDistant_m &&
         std::abs(hit.z_m) < kMostDistant_m && hit.count > 0;  // NaN compares false
}

std::size_t slot_of(std::uint64_t key, std::size_t slots) {
  key ^= key >> 31;
  key *= 0x9e3779b97f4a7c15ULL;
  return static_cast<std::size_t>(key >> 32) & (slots - 1);
}

}  // namespace

void HitMap::clear() { *this = HitMap(); }

void HitMap::grow() {
  slots_.assign(slots_.empty() ? 1024 : 2 * slots_.size(), 0);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    std::size_t at = slot_of(cells_[i].key, slots_.size());
    while (slots_[at] != 0) at = (at + 1) & (slots_.size() - 1);
    slots_[at] = static_cast<std::uint32_t>(i + 1);
  }
}

HitMap::Sum& HitMap::cell_at(std::uint64_t key, int level) {
  if (2 * (cells_.size() + 1) > slots_.size()) grow();
  std::size_t at = slot_of(key, slots_.size());
  for (; slots_[at] != 0; at = (at + 1) & (slots_.size() - 1)) {
    Sum& known = cells_[slots_[at] - 1];
    if (known.key == key) return known;
  }
  cells_.push_back({.key = key, .level = level});
  slots_[at] = static_cast<std::uint32_t>(cells_.size());
  return cells_.back();
}

void HitMap::add(const std::vector<CellHit>& hits, double resolution_m, double cell_m) {
  for (const CellHit& hit : hits) {
    if (!is_usable(hit)) continue;
    const std::uint64_t key = axis_index(hit.x_m, cell_m) << (2 * kAxisBits) |
                              axis_index(hit.y_m, cell_m) << kAxisBits | axis_index(hit.z_m, resolution_m);
    Sum& sum = cell_at(key, level_of(hit.z_m, resolution_m));
    sum.x_m += static_cast<double>(hit.x_m) * hit.count;
    sum.y_m += static_cast<double>(hit.y_m) * hit.count;
    sum.z_m += static_cast<double>(hit.z_m) * hit.count;
    sum.count += hit.count;
    count_ += hit.count;
  }
}

void HitMap::add(const HitMap& other) {
  for (const Sum& cell : other.cells_) {
    Sum& sum = cell_at(cell.key, cell.level);
    sum.x_m += cell.x_m;
    sum.y_m += cell.y_m;
    sum.z_m += cell.z_m;
    sum.count += cell.count;
  }
  count_ += other.count_;
}

std::vector<WallPoint> HitMap::points(int from_level, int to_level) const {
  std::vector<WallPoint> points;
  for (const Sum& cell : cells_) {
    if (cell.level < from_level || cell.level >= to_level) continue;
    points.push_back({{cell.x_m / cell.count, cell.y_m / cell.count}, cell.count});
  }
  return points;
}

std::vector<HitMap::Sum> HitMap::columns(int from_level, int to_level) const {
  HitMap upright;
  for (const Sum& cell : cells_) {
    if (cell.level < from_level || cell.level >= to_level) continue;
    Sum& sum = upright.cell_at(cell.key >> kAxisBits, from_level);
    sum.x_m += cell.x_m;
    sum.y_m += cell.y_m;
    sum.z_m += cell.z_m;
    sum.count += cell.count;
  }
  return std::move(upright.cells_);
}

}  // namespace enfilade::room_detector
