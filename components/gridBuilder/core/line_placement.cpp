// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/line_placement.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::grid_builder {

ScanLine place(const BaseLine& line, const Point3f& origin_base, const Pose2& T_zone_base) {
  const double c = std::cos(T_zone_base.yaw_rad), s = std::sin(T_zone_base.yaw_rad);
  const auto to_zone = [&](const Point3f& p) {
    return Point3f{static_cast<float>(T_zone_base.x_m + c * p.x_m - s * p.y_m),
                   static_cast<float>(T_zone_base.y_m + s * p.x_m + c * p.y_m), p.z_m};
  };
  ScanLine placed{line.stamp_ns, to_zone(origin_base), line.hits, line.free_ends};
  std::transform(placed.hits.begin(), placed.hits.end(), placed.hits.begin(), to_zone);
  std::transform(placed.free_ends.begin(), placed.free_ends.end(), placed.free_ends.begin(), to_zone);
  return placed;
}

}  // namespace enfilade::grid_builder
