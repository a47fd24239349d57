// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "components/gridBuilder/core/zone_grid.hpp"
#include "interfaces/geometry/angles.hpp"

namespace enfilade::grid_builder {

struct Box {
  Eigen::Vector3d low, high;
};

/// A room seen from inside and furniture seen from outside, all of them boxes; casts the lines of an ideal
/// rolling laser.
struct BoxRoom {
  Box walls{{-3.013, -2.507, 0.004}, {2.998, 2.511, 2.597}};
  std::vector<Box> furniture;

  /// Share of the ray `direction` at which it meets the first surface.
  double range_m(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const {
    double nearest = crossing(walls, from, direction).second;
    for (const Box& box : furniture) {
      const auto [enter, leave] = crossing(box, from, direction);
      if (enter < leave && enter > 0.0) nearest = std::min(nearest, enter);
    }
    return nearest;
  }

  /// One line of `beams` beams over 270° at roll angle `roll_rad`.
  ScanLine scan(StampNs stamp_ns, const Eigen::Vector3d& from, double roll_rad, int beams = 1081) const {
    ScanLine line{stamp_ns, as_point(from), {}, {}};
    for (int i = 0; i < beams; ++i) {
      const double a = radians(-135.0 + 270.0 * i / (beams - 1));
      const Eigen::Vector3d direction{std::cos(a), std::sin(a) * std::cos(roll_rad),
                                      std::sin(a) * std::sin(roll_rad)};
      line.hits.push_back(as_point(from + range_m(from, direction) * direction));
    }
    return line;
  }

  static BoxRoom random(std::mt19937& engine) {
    const auto between = [&engine](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(engine);
    };
    BoxRoom room{
        {{-between(1.5, 4), -between(1.5, 4), 0.004}, {between(1.5, 4), between(1.5, 4), between(2.2, 3.2)}},
        {}};
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d low{between(-3, 2.5), between(0.4, 2.5), 0.0};
      room.furniture.push_back(
          {low, low + Eigen::Vector3d{between(0.2, 1), between(0.2, 1), between(0.3, 2)}});
    }
    return room;
  }

 private:
  static Point3f as_point(const Eigen::Vector3d& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
  }

  static std::pair<double, double> crossing(const Box& box, const Eigen::Vector3d& from,
                                            const Eigen::Vector3d& d) {
    const Eigen::Array3d a = (box.low - from).array() / d.array(), b = (box.high - from).array() / d.array();
    return {a.min(b).maxCoeff(), a.max(b).minCoeff()};
  }
};

}  // namespace enfilade::grid_builder
