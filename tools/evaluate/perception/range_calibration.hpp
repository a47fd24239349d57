// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "components/laser3D/core/point_file.hpp"

namespace enfilade::evaluate {

/// What the laser measures too much, from a room of which one side was measured by hand.
struct RangeCalibration {
  double bias_m = 0.0;
  double sigma_m = 0.0;      ///< of bias_m, statistical
  double measured_m = 0.0;   ///< that side before the correction …
  double corrected_m = 0.0;  ///< … and after it
};

/// From a recorded cloud; nothing where no room with a side near `width_m` is found in it.
std::optional<RangeCalibration> calibrate_range(const laser_3d::ScannedPoints& cloud, double width_m);

/// From two sweeps of the simulated sensor, which measures `true_bias_m` too much, in a bare room.
std::optional<RangeCalibration> calibrate_simulated_range(double width_m, double true_bias_m,
                                                          std::uint64_t seed);

}  // namespace enfilade::evaluate
