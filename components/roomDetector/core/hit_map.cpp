// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/hit_map.hpp"

#include <cmath>

namespace enfilade::room_detector {
namespace {

constexpr std::uint64_t kAxisMask = (1u << 20) - 1;

std::uint64_t axis_index(double metres, double resolution_m) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(metres / resolution_m))) & kAxisMask;
}

}  // namespace

void HitMap::clear() { *this = HitMap(); }

void HitMap::add(const std::vector<CellHit>& hits, double resolution_m, double cell_m) {
  for (const CellHit& hit : hits) {
    const std::uint64_t key = axis_index(hit.x_m, cell_m) << 40 | axis_index(hit.y_m, cell_m) << 20 |
                              axis_index(hit.z_m, resolution_m);
    const auto [entry, is_new] = index_.try_emplace(key, cells_.size());
    if (is_new) cells_.push_back({.level = level_of(hit.z_m, resolution_m)});
    Sum& sum = cells_[entry->second];
    sum.x_m += static_cast<double>(hit.x_m) * hit.count;
    sum.y_m += static_cast<double>(hit.y_m) * hit.count;
    sum.count += hit.count;
    count_ += hit.count;
  }
}

std::vector<WallPoint> HitMap::points(int from_level, int to_level) const {
  std::vector<WallPoint> points;
  for (const Sum& cell : cells_) {
    if (cell.level < from_level || cell.level >= to_level) continue;
    points.push_back({{cell.x_m / cell.count, cell.y_m / cell.count}, cell.count});
  }
  return points;
}

}  // namespace enfilade::room_detector
