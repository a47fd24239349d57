// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "interfaces/model/sensing.hpp"

namespace enfilade::laser_3d {

struct FloorEstimatorConfig {
  double layer_m = 0.05;       ///< height of one layer of the histogram, > 0
  double cell_m = 0.10;        ///< a layer's extent is counted in square cells of this side, > 0
  double reach_m = 8.0;        ///< points further from the scanner are not looked at, > 0
  double least_below_m = 0.2;  ///< the floor is at least this far below the scanner, >= 0
  double strong_share =
      0.3;  ///< a layer is strong with this share of the cells of the widest layer below the scanner, (0, 1]
  double refine_m = 0.04;  ///< the floor is the median of the points this close to it, > 0
};

/// Finds the floor in a cloud taken by an upright scanner at the origin, z up: the lowest of the strong
/// horizontal layers.
///
/// A layer counts by the area it covers and not by its points, so that neither the dense foot of a wall nor a
/// cupboard near the scanner outweighs a thinly sampled floor.
class FloorEstimator {
 public:
  explicit FloorEstimator(const FloorEstimatorConfig& config);

  /// Height of the floor over the scanner (negative); nothing where no point lies below the scanner.
  std::optional<double> estimate(const std::vector<Point3f>& points) const;

 private:
  FloorEstimatorConfig config_;
};

}  // namespace enfilade::laser_3d
