// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/odometry_buffer.hpp"

#include <gtest/gtest.h>

namespace enfilade::grid_builder {
namespace {

Odometry sample(double time_s, const Pose2& T_odom_base, double linear_m_s = 0.0) {
  return {from_seconds(time_s), to_transform3(T_odom_base), linear_m_s, 0.0};
}

TEST(OdometryBuffer, InterpolatesBetweenSamples) {
  OdometryBuffer buffer({});
  buffer.add(sample(1.0, {1.0, 2.0, 3.1}));
  buffer.add(sample(1.2, {2.0, 2.0, -3.1}));
  const auto moment = buffer.find_moment(from_seconds(1.1));
  ASSERT_TRUE(moment);
  EXPECT_NEAR(moment->T_odom_base.x_m, 1.5, 1e-9);
  EXPECT_NEAR(std::abs(moment->T_odom_base.yaw_rad), kPi, 1e-9);  // the short way round
}

TEST(OdometryBuffer, WaitsForASampleAtOrAfterTheStamp) {
  OdometryBuffer buffer({});
  EXPECT_FALSE(buffer.reaches(0));
  buffer.add(sample(1.0, {}));
  EXPECT_TRUE(buffer.reaches(from_seconds(1.0)));
  EXPECT_FALSE(buffer.reaches(from_seconds(1.1)));
  EXPECT_TRUE(buffer.find_moment(from_seconds(1.0)));
  EXPECT_FALSE(buffer.find_moment(from_seconds(0.9)));
}

TEST(OdometryBuffer, MakesNoPoseUpInAGap) {
  OdometryBuffer buffer({.max_gap_s = 0.5});
  buffer.add(sample(1.0, {}));
  buffer.add(sample(1.6, {}));
  EXPECT_FALSE(buffer.find_moment(from_seconds(1.3)));
}

TEST(OdometryBuffer, CallsTheBaseMovingIfEitherNeighbourIs) {
  OdometryBuffer buffer({});
  buffer.add(sample(1.0, {}));
  buffer.add(sample(1.1, {}, 0.1));
  buffer.add(sample(1.2, {}, 0.1));
  EXPECT_FALSE(buffer.find_moment(from_seconds(1.0))->moving);
  EXPECT_TRUE(buffer.find_moment(from_seconds(1.05))->moving);
}

TEST(OdometryBuffer, ForgetsTheOldest) {
  OdometryBuffer buffer({.max_samples = 3});
  for (int i = 0; i < 10; ++i) buffer.add(sample(0.1 * i, {}));
  EXPECT_FALSE(buffer.find_moment(from_seconds(0.65)));
  EXPECT_TRUE(buffer.find_moment(from_seconds(0.75)));
}

}  // namespace
}  // namespace enfilade::grid_builder
