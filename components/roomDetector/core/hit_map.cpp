// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/hit_map.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::room_detector {
namespace {

constexpr int kAxisBits = 20;
constexpr std::uint64_t kAxisMask = (1u << kAxisBits) - 1;
constexpr double kMostDistant_m = 1000.0;
constexpr double kBlock_m = 0.5;  // as wide as a few gaps in a wall are

bool is_usable(const CellHit& hit) {
  return std::abs(hit.x_m) < kMostDistant_m && std::abs(hit.y_m) < kMostDistant_m &&
         std::abs(hit.z_m) < kMostDistant_m && hit.count > 0;  // NaN compares false
}

/// One axis of a key, with its sign.
int axis_of(std::uint64_t key, int axis) {
  const auto bits = static_cast<std::uint32_t>(key >> (axis * kAxisBits) & kAxisMask);
  return static_cast<std::int32_t>(bits << (32 - kAxisBits)) >> (32 - kAxisBits);
}

int cell_index(double metres, double cell_m) { return static_cast<int>(std::floor(metres / cell_m)); }

}  // namespace

HitMap::Corner HitMap::corner_of(std::uint64_t key) {
  return {axis_of(key, 2), axis_of(key, 1), axis_of(key, 0)};
}

std::uint64_t HitMap::key_of(const Corner& c) {
  const auto bits = [](int i) { return static_cast<std::uint64_t>(i) & kAxisMask; };
  return bits(c.x) << (2 * kAxisBits) | bits(c.y) << kAxisBits | bits(c.z);
}

HitMap::Sum HitMap::sum_of(const Cell& cell) const {
  const Corner corner = corner_of(cell.key);
  const double count = cell.count;
  return {corner.x * cell_m_ * count + cell.x_m, corner.y * cell_m_ * count + cell.y_m,
          corner.z * resolution_m_ * count + cell.z_m, count};
}

void HitMap::clear() { *this = HitMap(); }

void HitMap::add(const std::vector<CellHit>& hits, double resolution_m, double cell_m) {
  cell_m_ = cell_m;
  resolution_m_ = resolution_m;
  for (const CellHit& hit : hits) {
    if (!is_usable(hit)) continue;
    const Corner corner{cell_index(hit.x_m, cell_m), cell_index(hit.y_m, cell_m),
                        layer_of(hit.z_m, resolution_m)};
    const auto offset = [&](float metres, int index, double side_m) {
      return static_cast<float>((metres - index * side_m) * hit.count);
    };
    add({key_of(corner), offset(hit.x_m, corner.x, cell_m), offset(hit.y_m, corner.y, cell_m),
         offset(hit.z_m, corner.z, resolution_m), hit.count});
  }
}

void HitMap::add(const HitMap& other) {
  if (cells_.entries().empty()) {
    cell_m_ = other.cell_m_;
    resolution_m_ = other.resolution_m_;
  }
  for (const Cell& cell : other.cells_.entries()) add(cell);
}

void HitMap::add(const Cell& more) {
  Cell& cell = cells_.at(more.key);
  if (cell.count == 0) add_to_block(more.key);
  cell.x_m += more.x_m;
  cell.y_m += more.y_m;
  cell.z_m += more.z_m;
  cell.count += more.count;
  count_ += more.count;
  add_to_column(more);
}

int HitMap::cells_per_block() const { return std::max(1, static_cast<int>(std::lround(kBlock_m / cell_m_))); }

void HitMap::add_to_block(std::uint64_t key) {
  const Corner corner = corner_of(key);
  const double side = cells_per_block();
  const auto block = [&](int cell) { return static_cast<int>(std::floor(cell / side)); };
  const auto place = static_cast<std::uint32_t>(cells_.entries().size() - 1);
  blocks_.at(key_of({block(corner.x), block(corner.y), 0})).cells.push_back(place);
}

Point2 HitMap::centre_of(const Block& block) const {
  const Corner corner = corner_of(block.key);
  const double side_m = cells_per_block() * cell_m_;
  return {(corner.x + 0.5) * side_m, (corner.y + 0.5) * side_m};
}

std::vector<WallPoint> HitMap::points(int from_level, int to_level) const {
  std::vector<WallPoint> points;
  for (const Cell& cell : cells_.entries()) {
    if (!is_within(cell, from_level, to_level)) continue;
    const Sum sum = sum_of(cell);
    points.push_back({{sum.x_m / sum.count, sum.y_m / sum.count}, sum.count});
  }
  return points;
}

bool HitMap::is_within(const Cell& cell, int from_level, int to_level) {
  const int level = std::clamp(axis_of(cell.key, 0) + kBelowFloor, 0, kLevels);
  return level >= from_level && level < to_level;
}

void HitMap::follow(const WallBand& band) {
  if (band == followed_) return;
  followed_ = band;
  columns_ = {};
  for (const Cell& cell : cells_.entries()) add_to_column(cell);
}

void HitMap::add_to_column(const Cell& more) {
  if (!is_within(more, followed_.from, followed_.to)) return;
  const Sum sum_of_more = sum_of(more);
  Sum& sum = columns_.at(more.key >> kAxisBits).sum;
  sum.x_m += sum_of_more.x_m;
  sum.y_m += sum_of_more.y_m;
  sum.z_m += sum_of_more.z_m;
  sum.count += sum_of_more.count;
}

}  // namespace enfilade::room_detector
