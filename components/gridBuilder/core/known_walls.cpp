// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/known_walls.hpp"

#include <cmath>

namespace enfilade::grid_builder {

KnownWalls known_walls(const RoomEstimate& estimate, double max_sigma_m) {
  KnownWalls walls{.rectangle = estimate.rectangle};
  if (!estimate.covariance) return walls;
  const Eigen::Map<const Eigen::Matrix<double, 5, 5, Eigen::RowMajor>> P(estimate.covariance->data());
  for (int wall = 0; wall < 4; ++wall) {
    const Point2 normal = estimate.rectangle.normal(wall);
    Eigen::Matrix<double, 5, 1> outwards = Eigen::Matrix<double, 5, 1>::Zero();  // by (α, x, y, w, h)
    outwards << 0.0, normal.x(), normal.y(), wall % 2 == 0 ? 0.5 : 0.0, wall % 2 == 0 ? 0.0 : 0.5;
    walls.seen[static_cast<std::size_t>(wall)] = outwards.dot(P * outwards) <= max_sigma_m * max_sigma_m;
  }
  return walls;
}

}  // namespace enfilade::grid_builder
