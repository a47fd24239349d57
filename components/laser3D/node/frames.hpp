// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/laser3D/core/scan_projector.hpp"
#include "interfaces/model/transform.hpp"

namespace enfilade::laser_3d {

inline constexpr const char* kBaseFrame = "base_link";
inline constexpr const char* kLaserFrame = "laser";  ///< on its mount, not rolled
inline constexpr const char* kLaserScanFrame =
    "laser_scan";  ///< the scan plane, rolled about the laser's x axis

/// rt/tf_static: base_link → laser, a pure translation.
TransformList mount_transform(StampNs stamp_ns, double x_m, double y_m, double z_m);
/// rt/tf: laser → laser_scan.
TransformList roll_transform(StampNs stamp_ns, double roll_rad);

}  // namespace enfilade::laser_3d
