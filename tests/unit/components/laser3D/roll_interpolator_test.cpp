// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/roll_interpolator.hpp"

#include <gtest/gtest.h>

namespace enfilade::laser_3d {
namespace {

constexpr StampNs kPeriod_ns = 5'000'000;

double steady(StampNs stamp_ns) { return -1.5 + 0.7 * seconds(stamp_ns); }

RollInterpolator sampled_for(int samples, RollInterpolatorConfig config = {}) {
  RollInterpolator roll(config);
  for (int i = 0; i < samples; ++i) roll.add(i * kPeriod_ns, steady(i * kPeriod_ns));
  return roll;
}

TEST(RollInterpolator, IsExactForSteadyMotion) {
  const RollInterpolator roll = sampled_for(100);
  for (StampNs t = 0; t <= 99 * kPeriod_ns; t += 123'457) {
    ASSERT_TRUE(roll.angle_at(t));
    EXPECT_NEAR(*roll.angle_at(t), steady(t), 1e-12);
  }
}

TEST(RollInterpolator, KnowsNothingBeforeTheFirstAndAfterTheLastSample) {
  RollInterpolator roll{RollInterpolatorConfig{}};
  EXPECT_FALSE(roll.angle_at(0));
  EXPECT_EQ(roll.coverage(0, 10), Coverage::kNotYet);
  roll.add(100, 0.5);
  EXPECT_FALSE(roll.angle_at(99));
  EXPECT_EQ(roll.angle_at(100), 0.5);
  EXPECT_FALSE(roll.angle_at(101));
}

TEST(RollInterpolator, TellsWhatIsKnownWhatWillBeAndWhatNeverWillBe) {
  const RollInterpolator roll = sampled_for(10);
  EXPECT_EQ(roll.coverage(0, 9 * kPeriod_ns), Coverage::kKnown);
  EXPECT_EQ(roll.coverage(kPeriod_ns, 9 * kPeriod_ns + 1), Coverage::kNotYet);
  EXPECT_EQ(roll.coverage(-1, kPeriod_ns), Coverage::kUnknown);
}

TEST(RollInterpolator, KeepsABoundedHistory) {
  const RollInterpolator roll = sampled_for(50, {.history = 10});
  EXPECT_EQ(roll.coverage(40 * kPeriod_ns, 49 * kPeriod_ns), Coverage::kKnown);
  EXPECT_EQ(roll.coverage(39 * kPeriod_ns, 49 * kPeriod_ns), Coverage::kUnknown);
}

TEST(RollInterpolator, DoesNotBridgeAGap) {
  RollInterpolator roll = sampled_for(10);
  const StampNs resumed_ns = 9 * kPeriod_ns + from_seconds(0.2);
  roll.add(resumed_ns, 1.0);
  EXPECT_FALSE(roll.angle_at(resumed_ns - kPeriod_ns));
  EXPECT_EQ(roll.coverage(8 * kPeriod_ns, 9 * kPeriod_ns + 1), Coverage::kUnknown);
  EXPECT_EQ(roll.coverage(resumed_ns - 1, resumed_ns), Coverage::kUnknown);
  EXPECT_EQ(roll.coverage(8 * kPeriod_ns, 9 * kPeriod_ns), Coverage::kKnown);
}

TEST(RollInterpolator, IgnoresOldSamples) {
  RollInterpolator roll = sampled_for(10);
  roll.add(4 * kPeriod_ns + 1, 99.0);
  EXPECT_NEAR(*roll.angle_at(4 * kPeriod_ns + 1), steady(4 * kPeriod_ns + 1), 1e-12);
}

}  // namespace
}  // namespace enfilade::laser_3d
