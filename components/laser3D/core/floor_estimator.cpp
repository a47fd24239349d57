// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/floor_estimator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

#include <Eigen/Cholesky>

namespace enfilade::laser_3d {
namespace {

/// z = slope_x · x + slope_y · y + height: a plane that is not steep.
using Plane = Eigen::Vector3d;

int index_of(float value_m, double step_m) { return static_cast<int>(std::floor(value_m / step_m)); }

std::vector<Point3f> points_below(const std::vector<Point3f>& points, const FloorEstimatorConfig& config) {
  std::vector<Point3f> below;
  for (const Point3f& p : points) {
    if (p.z_m <= -config.least_below_m && std::hypot(p.x_m, p.y_m, p.z_m) <= config.reach_m)
      below.push_back(p);
  }
  return below;
}

/// How many cells each layer covers, together with the layers above and below it: a floor that leans or lies
/// on the border of two layers is one floor.
std::map<int, int> layer_extents(const std::vector<Point3f>& points, const FloorEstimatorConfig& config) {
  std::vector<std::array<int, 3>> cells;  // layer, column, row
  for (const Point3f& p : points)
    cells.push_back(
        {index_of(p.z_m, config.layer_m), index_of(p.x_m, config.cell_m), index_of(p.y_m, config.cell_m)});
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::map<int, int> extents;
  for (const auto& cell : cells)
    for (const int layer : {cell[0] - 1, cell[0], cell[0] + 1}) ++extents[layer];
  return extents;
}

/// Height of the middle of the lowest layer that is strong and no less wide than its neighbours.
double lowest_strong_height_m(const std::map<int, int>& extents, const FloorEstimatorConfig& config) {
  const auto by_extent = [](const auto& a, const auto& b) { return a.second < b.second; };
  const int widest = std::max_element(extents.begin(), extents.end(), by_extent)->second;
  auto layer = std::find_if(extents.begin(), extents.end(),
                            [&](const auto& l) { return l.second >= config.strong_share * widest; });
  for (auto above = std::next(layer); above != extents.end() && above->first == layer->first + 1; ++above) {
    if (above->second <= layer->second) break;
    layer = above;
  }
  return (layer->first + 0.5) * config.layer_m;
}

double off_plane_m(const Plane& plane, const Point3f& p) {
  return p.z_m - plane.dot(Eigen::Vector3d(p.x_m, p.y_m, 1.0));
}

/// For each cell the point in the middle of those within `band_m` of the plane, so that every piece of floor
/// counts once.
std::vector<Point3f> middle_points(const std::vector<Point3f>& points, const Plane& plane, double band_m,
                                   double cell_m) {
  std::vector<std::tuple<int, int, float, std::size_t>> near;  // column, row, height, index
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(off_plane_m(plane, points[i])) <= band_m)
      near.emplace_back(index_of(points[i].x_m, cell_m), index_of(points[i].y_m, cell_m), points[i].z_m, i);
  }
  std::sort(near.begin(), near.end());
  const auto cell_of = [&](std::size_t k) { return std::pair(std::get<0>(near[k]), std::get<1>(near[k])); };
  std::vector<Point3f> middle;
  for (std::size_t from = 0, to = 0; from < near.size(); from = to) {
    while (to < near.size() && cell_of(to) == cell_of(from)) ++to;
    middle.push_back(points[std::get<3>(near[from + (to - from) / 2])]);
  }
  return middle;
}

std::optional<Plane> fit_plane(const std::vector<Point3f>& points) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Point3f& p : points) {
    const Eigen::Vector3d row(p.x_m, p.y_m, 1.0);
    normal += row * row.transpose();
    right += row * static_cast<double>(p.z_m);
  }
  const Eigen::LDLT<Eigen::Matrix3d> solver(normal);
  if (points.size() < 10 || solver.info() != Eigen::Success || solver.rcond() < 1e-9) return std::nullopt;
  return solver.solve(right);
}

}  // namespace

FloorEstimator::FloorEstimator(const FloorEstimatorConfig& config) : config_(config) {
  const double lowest = std::min({config.layer_m, config.cell_m, config.reach_m, config.strong_share});
  if (!(lowest > 0.0) || !(config.strong_share <= 1.0) || !(config.least_below_m >= 0.0))
    throw std::invalid_argument("floor: measures must be greater than 0 and strong_share at most 1");
  if (!(config.max_tilt_rad >= 0.0 && config.max_tilt_rad <= 0.5))
    throw std::invalid_argument("floor: max_tilt_rad must be within 0 and 0.5");
}

std::optional<Floor> FloorEstimator::estimate(const std::vector<Point3f>& points) const {
  const std::vector<Point3f> below = points_below(points, config_);
  if (below.empty()) return std::nullopt;
  Plane plane(0.0, 0.0, lowest_strong_height_m(layer_extents(below, config_), config_));
  // The band shrinks so that the feet of walls, which lie above the floor only, weigh less and less.
  for (const double layers : {4.0, 2.0, 1.0, 0.5, 0.5, 0.5}) {
    const auto better = fit_plane(middle_points(below, plane, layers * config_.layer_m, config_.cell_m));
    if (!better || better->head<2>().norm() > std::tan(config_.max_tilt_rad)) break;
    plane = *better;
  }
  const Eigen::Vector3d normal(-plane[0], -plane[1], 1.0);
  return Floor{.below_m = -plane[2] / normal.norm(), .up = normal.normalized()};
}

}  // namespace enfilade::laser_3d
