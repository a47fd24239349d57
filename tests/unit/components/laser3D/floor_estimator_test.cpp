// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/floor_estimator.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/unit/components/laser3D/synthetic_room.hpp"

namespace enfilade::laser_3d {
namespace {

const FloorEstimator kEstimator{FloorEstimatorConfig{}};

TEST(FloorEstimator, FindsTheFloorOfAFurnishedRoomWithinACentimetre) {
  // Heights in between put the floor anywhere within a layer of the histogram.
  for (double height_m = 0.5; height_m < 2.2; height_m += 0.0537) {
    EXPECT_NEAR(kEstimator.estimate(synthetic_room(height_m))->below_m, height_m, 0.01);
  }
}

TEST(FloorEstimator, IsTheSameWhicheverWayTheScannerLooked) {
  std::vector<Point3f> turned = synthetic_room(1.3);
  for (Point3f& p : turned) p = {-p.y_m, p.x_m, p.z_m};
  const Floor floor = kEstimator.estimate(synthetic_room(1.3)).value(),
              same = kEstimator.estimate(turned).value();
  EXPECT_NEAR(same.below_m, floor.below_m, 1e-3);
  EXPECT_NEAR(same.up.x(), -floor.up.y(), 1e-3);
  EXPECT_NEAR(same.up.y(), floor.up.x(), 1e-3);
}

TEST(FloorEstimator, FindsHowMuchTheScannerLeans) {
  for (const double tilt_rad : {-0.05, -0.02, 0.0, 0.02, 0.05}) {
    const Eigen::AngleAxisd lean(tilt_rad, Eigen::Vector3d(1.0, 2.0, 0.0).normalized());
    std::vector<Point3f> points = synthetic_room(1.3);
    for (Point3f& p : points) {
      const Eigen::Vector3f q = lean.cast<float>() * Eigen::Vector3f(p.x_m, p.y_m, p.z_m);
      p = {q.x(), q.y(), q.z()};
    }
    const Floor floor = kEstimator.estimate(points).value();
    EXPECT_NEAR(floor.below_m, 1.3, 0.01) << tilt_rad;
    EXPECT_LT(std::acos(floor.up.dot(lean * Eigen::Vector3d::UnitZ())), 0.005) << tilt_rad;
  }
}

TEST(FloorEstimator, SaysSoWhereNothingIsBelowTheScanner) {
  EXPECT_FALSE(kEstimator.estimate({}));
  EXPECT_FALSE(kEstimator.estimate({{1.0f, 0.0f, 0.5f}, {1.0f, 0.0f, -0.1f}}));
}

TEST(FloorEstimator, RefusesMeasuresOfZero) {
  EXPECT_THROW(FloorEstimator({.layer_m = 0.0}), std::invalid_argument);
  EXPECT_THROW(FloorEstimator({.strong_share = 1.1}), std::invalid_argument);
}

}  // namespace
}  // namespace enfilade::laser_3d
