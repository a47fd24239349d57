// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/wall_band.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::room_detector {
namespace {

constexpr double kLowestCeiling_m = 1.8;
constexpr double kCeilingToWallRatio = 3.0;
constexpr double kLeastUpperToBodyRatio = 0.2;
constexpr double kLeastUpperOutline_m = 1.5;
constexpr double kLowestWall_m = 0.6;  // what ends below may be a step or a bench

/// Mean number of occupied cells of the levels from ≤ l < to.
double mean_occupied(const ColumnMap& map, int from, int to) {
  double sum = 0.0;
  for (int l = from; l < to; ++l) sum += map.occupied_per_level()[static_cast<std::size_t>(l)];
  return to > from ? sum / (to - from) : 0.0;
}

/// Whether walls are seen above the furniture too: low arena walls and a sensor that looks level have no
/// upper band.
bool holds_enough(const ColumnMap& map, const WallBand& upper, int body_from) {
  const double outline_cells = mean_occupied(map, upper.from, upper.to);
  return outline_cells * map.resolution_m() >= kLeastUpperOutline_m &&
         outline_cells >= kLeastUpperToBodyRatio * mean_occupied(map, body_from, upper.from);
}

/// Whether most levels of the band hold walls; a slab fills but one.
bool holds_walls(const ColumnMap& map, const WallBand& band, int body_from) {
  const double least = std::max(kLeastUpperOutline_m / map.resolution_m(),
                                kLeastUpperToBodyRatio * mean_occupied(map, body_from, band.from));
  const auto from = map.occupied_per_level().begin() + band.from;
  return 2 * std::count_if(from, from + band.size(), [&](int cells) { return cells >= least; }) > band.size();
}

/// Where walls end below the upper band, as those of an arena do: the highest of the bands of `height` levels
/// stacked under `to` in which they are seen.
std::optional<WallBand> top_of_walls(const ColumnMap& map, int to, int height, int body_from) {
  const int lowest = level_of(kLowestWall_m, map.resolution_m());
  if (height <= 0) return std::nullopt;  // cells as high as the band
  for (; to - height >= lowest; to -= height) {
    const WallBand band{to - height, to, true};
    if (holds_walls(map, band, body_from)) return band;
  }
  return std::nullopt;
}

}  // namespace

std::optional<int> find_ceiling(const ColumnMap& map) {
  const auto& count = map.occupied_per_level();
  const int lowest = level_of(kLowestCeiling_m, map.resolution_m());
  const auto fullest = std::max_element(count.begin() + lowest, count.end());
  const double walls = mean_occupied(map, level_of(0.3, map.resolution_m()), lowest);
  const double least = std::max(kCeilingToWallRatio * walls, 1.0 / (map.resolution_m() * map.resolution_m()));
  if (fullest == count.end() || *fullest < least) return std::nullopt;
  auto level = fullest;  // noise spreads the plane over neighbouring layers
  while (level - 1 >= count.begin() + lowest && 2 * *(level - 1) >= *fullest) --level;
  return static_cast<int>(level - count.begin());
}

WallBand choose_wall_band(const ColumnMap& map, const WallBandConfig& config) {
  const double r = map.resolution_m();
  const auto ceiling = find_ceiling(map);
  const int top =
      ceiling ? *ceiling - static_cast<int>(std::ceil(config.ceiling_margin_m / r - 1e-6)) : kLevels;
  const WallBand all{level_of(config.floor_margin_m, r), top, false};
  const WallBand upper{level_of(config.wall_band_from_m, r),
                       std::min(top, level_of(config.wall_band_to_m, r)), true};
  switch (config.band) {
    case BandChoice::kAll:
      return all;
    case BandChoice::kUpper:
      return upper;
    case BandChoice::kAuto:
      break;
  }
  if (upper.size() > 0 && holds_enough(map, upper, all.from)) return upper;
  return top_of_walls(map, upper.from, level_of(config.wall_band_to_m, r) - upper.from, all.from)
      .value_or(all);
}

}  // namespace enfilade::room_detector
