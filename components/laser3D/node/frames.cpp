// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/node/frames.hpp"

#include <cmath>

namespace enfilade::laser_3d {

TransformList mount_transform(StampNs stamp_ns, double x_m, double y_m, double z_m) {
  return {.transforms = {{stamp_ns, kBaseFrame, kLaserFrame, {.x_m = x_m, .y_m = y_m, .z_m = z_m}}}};
}

TransformList roll_transform(StampNs stamp_ns, double roll_rad) {
  const Transform3 T_laser_scan{.qx = std::sin(0.5 * roll_rad), .qw = std::cos(0.5 * roll_rad)};
  return {.transforms = {{stamp_ns, kLaserFrame, kLaserScanFrame, T_laser_scan}}};
}

}  // namespace enfilade::laser_3d
