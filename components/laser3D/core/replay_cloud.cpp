// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/replay_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>

namespace enfilade::laser_3d {
namespace {

Point3f minus(const Point3f& a, const Point3f& b) { return {a.x_m - b.x_m, a.y_m - b.y_m, a.z_m - b.z_m}; }

Point3f lifted(const Eigen::Quaterniond& level, double height_m, const Point3f& p) {
  const Eigen::Vector3d q = level * Eigen::Vector3d(p.x_m, p.y_m, p.z_m);
  return {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z() + height_m)};
}

}  // namespace

std::optional<ReplayCloud> make_replay_cloud(const ReplayCloudConfig& config, const ScannedPoints& scanned) {
  if (!(config.floor_drop_m >= 0.0) || config.line_points < 1)
    throw std::invalid_argument("replay: floor_drop_m must not be negative and line_points at least 1");
  std::vector<Point3f> points = scanned.points;
  for (Point3f& p : points) p = minus(p, scanned.origin);
  const auto floor = FloorEstimator(config.floor).estimate(points);
  if (!floor) return std::nullopt;

  ReplayCloud cloud{.scanner_height_m = floor->below_m, .tilt_rad = std::acos(std::min(1.0, floor->up.z()))};
  const Eigen::Quaterniond level = Eigen::Quaterniond::FromTwoVectors(floor->up, Eigen::Vector3d::UnitZ());
  for (const Point3f& seen : points) {
    const Point3f p = lifted(level, floor->below_m, seen);
    if (p.z_m < config.floor_drop_m) {
      ++cloud.near_floor;
      continue;
    }
    if (cloud.points++ % static_cast<std::uint64_t>(config.line_points) == 0) cloud.lines.emplace_back();
    cloud.lines.back().push_back(p);
  }
  return cloud;
}

}  // namespace enfilade::laser_3d
