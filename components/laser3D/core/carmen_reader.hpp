// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "components/laser3D/core/text_lines.hpp"
#include "interfaces/geometry/pose2.hpp"

namespace enfilade::laser_3d {

/// One line of a level range finder.
struct CarmenScan {
  double stamp_s = 0.0;
  Pose2 T_map_laser;  ///< where the log says the laser was: the corrected pose, if the log was corrected
  Pose2 T_odom_base;  ///< raw odometry
  double first_angle_rad = 0.0, angle_step_rad = 0.0;  ///< counter-clockwise from the laser's x axis
  std::vector<float> ranges_m;  ///< REP-117: +inf nothing within reach, -inf too close, NaN invalid
};

struct CarmenOdometry {
  double stamp_s = 0.0;
  Pose2 T_odom_base;
};

struct CarmenLog {
  std::vector<CarmenScan> scans;  ///< at least one
  std::vector<CarmenOdometry> odometry;
};

/// Reads the FLASER, ROBOTLASER1 and ODOM lines of a CARMEN log; other lines are passed over. Throws
/// std::runtime_error with one sentence that names the file and the line; memory is bounded by the file's
/// size.
CarmenLog read_carmen(const FileBytes& file);

/// The returns of a scan no farther than `max_range_m` in the map's frame.
std::vector<Point2> returns_of(const CarmenScan& scan, double max_range_m);

}  // namespace enfilade::laser_3d
