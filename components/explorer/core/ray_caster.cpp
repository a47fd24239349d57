// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/ray_caster.hpp"

#include <cmath>

namespace enfilade::explorer {

bool is_visible(const ProjectedGrid& grid, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const double cells_per_m = 1.0 / grid.resolution_m();
  const Eigen::Vector3d a = from * cells_per_m, way = (to - from) * cells_per_m;
  const double length = way.norm();
  const Eigen::Vector3d step = way / length;
  for (double s = 1.0; s < length - 1.5; s += 0.9) {
    const Eigen::Vector3d p = a + s * step;
    const CellState state =
        grid.state(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())),
                   static_cast<int>(std::floor(p.z())));
    if (state == CellState::kOccupied) return false;
  }
  return true;
}

}  // namespace enfilade::explorer
