// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/floor_estimator.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

namespace enfilade::laser_3d {
namespace {

using Cell = std::tuple<int, int, int>;  // layer, column, row

int index_of(float value_m, double step_m) { return static_cast<int>(std::floor(value_m / step_m)); }

/// How many cells each layer below the scanner covers.
std::map<int, int> layer_extents(const std::vector<Point3f>& points, const FloorEstimatorConfig& config) {
  std::vector<Cell> cells;
  for (const Point3f& p : points) {
    const bool in_reach = std::hypot(p.x_m, p.y_m) <= config.reach_m && p.z_m >= -config.reach_m;
    if (in_reach && p.z_m <= -config.least_below_m)
      cells.emplace_back(index_of(p.z_m, config.layer_m), index_of(p.x_m, config.cell_m),
                         index_of(p.y_m, config.cell_m));
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::map<int, int> extents;
  for (const auto& [layer, column, row] : cells) ++extents[layer];
  return extents;
}

double median_z_m(const std::vector<Point3f>& points, double middle_m, const FloorEstimatorConfig& config) {
  std::vector<float> heights_m;
  for (const Point3f& p : points)
    if (std::hypot(p.x_m, p.y_m) <= config.reach_m && std::abs(p.z_m - middle_m) <= config.refine_m)
      heights_m.push_back(p.z_m);
  if (heights_m.empty()) return middle_m;
  const auto middle = heights_m.begin() + static_cast<std::ptrdiff_t>(heights_m.size() / 2);
  std::nth_element(heights_m.begin(), middle, heights_m.end());
  return *middle;
}

}  // namespace

FloorEstimator::FloorEstimator(const FloorEstimatorConfig& config) : config_(config) {
  const double lowest =
      std::min({config.layer_m, config.cell_m, config.reach_m, config.strong_share, config.refine_m});
  if (!(lowest > 0.0) || !(config.strong_share <= 1.0) || !(config.least_below_m >= 0.0))
    throw std::invalid_argument("floor: measures must be greater than 0 and strong_share at most 1");
}

std::optional<double> FloorEstimator::estimate(const std::vector<Point3f>& points) const {
  const std::map<int, int> extents = layer_extents(points, config_);
  if (extents.empty()) return std::nullopt;
  const auto by_extent = [](const auto& a, const auto& b) { return a.second < b.second; };
  const int widest = std::max_element(extents.begin(), extents.end(), by_extent)->second;
  auto floor = std::find_if(extents.begin(), extents.end(),
                            [&](const auto& layer) { return layer.second >= config_.strong_share * widest; });
  // The floor's points may be spread over two layers: climb to the wider one.
  while (std::next(floor) != extents.end() && std::next(floor)->first == floor->first + 1 &&
         std::next(floor)->second > floor->second)
    ++floor;
  double floor_m = (floor->first + 0.5) * config_.layer_m;
  for (int pass = 0; pass < 3; ++pass) floor_m = median_z_m(points, floor_m, config_);
  return floor_m;
}

}  // namespace enfilade::laser_3d
