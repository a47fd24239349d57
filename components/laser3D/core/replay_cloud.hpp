// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "components/laser3D/core/floor_estimator.hpp"
#include "components/laser3D/core/point_file.hpp"

namespace enfilade::laser_3d {

struct ReplayCloudConfig {
  double floor_drop_m = 0.2;  ///< points lower than this over the floor only show that the way there is free
  int line_points = 1081;     ///< points in each line but the last, >= 1
  FloorEstimatorConfig floor;
};

/// A recorded cloud made to look like lines of a robot's scanner: levelled, the robot under the scanner, the
/// floor at z = 0.
struct ReplayCloud {
  std::vector<std::vector<Point3f>> lines;
  std::vector<std::vector<Point3f>>
      free_ends;  ///< of each line: up to where its beams to the floor met nothing
  double scanner_height_m = 0.0;
  double tilt_rad = 0.0;         ///< how much the scanner leaned, before the cloud was levelled
  std::uint64_t points = 0;      ///< in all lines
  std::uint64_t near_floor = 0;  ///< in free_ends
};

/// Nothing where the cloud has no floor below its scanner.
std::optional<ReplayCloud> make_replay_cloud(const ReplayCloudConfig& config, const ScannedPoints& scanned);

}  // namespace enfilade::laser_3d
