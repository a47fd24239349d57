// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "interfaces/model/sensing.hpp"

namespace enfilade::laser_3d {

struct FloorEstimatorConfig {
  double layer_m = 0.05;       ///< height of one layer of the histogram, > 0
  double cell_m = 0.10;        ///< extents are counted in square cells of this side, > 0
  double reach_m = 8.0;        ///< points further from the scanner are not looked at, > 0
  double least_below_m = 0.2;  ///< the floor is at least this far below the scanner, >= 0
  double strong_share = 0.3;   ///< a layer is strong with this share of the widest layer's extent, (0, 1]
  double max_tilt_rad = 0.1;   ///< the scanner stands upright but for this, [0, 0.5]
};

/// A floor as the scanner sees it.
struct Floor {
  double below_m = 0.0;                           ///< distance of the scanner to the floor's plane
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  ///< the floor's normal, in the frame of the scanner
};

/// Finds the floor in a cloud taken by a scanner at the origin, z roughly up: the lowest of the strong
/// horizontal layers, refined by fitting a plane, because a scanner put down by hand leans by a degree or
/// two.
///
/// A layer counts by the area it covers and not by its points, so that neither the dense foot of a wall nor a
/// cupboard near the scanner outweighs a thinly sampled floor.
class FloorEstimator {
 public:
  explicit FloorEstimator(const FloorEstimatorConfig& config);

  /// Nothing where no point lies below the scanner.
  std::optional<Floor> estimate(const std::vector<Point3f>& points) const;

 private:
  FloorEstimatorConfig config_;
};

}  // namespace enfilade::laser_3d
