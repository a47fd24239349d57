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

constexpr float kBeforeFloor_m = 0.1F;

/// The place a little before `p` on the beam from the scanner.
Point3f short_of(const Point3f& p, float scanner_height_m) {
  const float up = p.z_m - scanner_height_m, length = std::hypot(p.x_m, p.y_m, up);
  const float share = length > kBeforeFloor_m ? 1.0F - kBeforeFloor_m / length : 0.0F;
  return {share * p.x_m, share * p.y_m, scanner_height_m + share * up};
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
  // Turns `up` to z: about up × z, with the half angle's cosine by (1 + up · z).
  const Eigen::Quaterniond level =
      Eigen::Quaterniond(1.0 + floor->up.z(), floor->up.y(), -floor->up.x(), 0.0).normalized();
  for (const Point3f& seen : points) {
    const Point3f p = lifted(level, floor->below_m, seen);
    const std::uint64_t count = cloud.points + cloud.near_floor;
    if (count % static_cast<std::uint64_t>(config.line_points) == 0) {
      cloud.lines.emplace_back();
      cloud.free_ends.emplace_back();
    }
    if (p.z_m < config.floor_drop_m) {
      ++cloud.near_floor;
      cloud.free_ends.back().push_back(short_of(p, static_cast<float>(cloud.scanner_height_m)));
    } else {
      ++cloud.points;
      cloud.lines.back().push_back(p);
    }
  }
  return cloud;
}

}  // namespace enfilade::laser_3d
