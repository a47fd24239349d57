// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/safety_guard.hpp"

#include <gtest/gtest.h>

namespace enfilade::explorer {
namespace {

bool stops(const VelocityCommand& v, const Point3f& p) { return !SafetyGuard({}).in_the_way(v, {p}).empty(); }

TEST(SafetyGuard, StopsForWhatIsStraightAhead) {
  EXPECT_TRUE(stops({0.35, 0.0}, {0.40F, 0.0F, 0.6F}));
  EXPECT_FALSE(stops({0.35, 0.0}, {0.60F, 0.0F, 0.6F}));
  EXPECT_TRUE(stops({-0.35, 0.0}, {-0.40F, 0.0F, 0.6F}));
}

TEST(SafetyGuard, PassesWhatStandsBeside) {
  EXPECT_FALSE(stops({0.35, 0.0}, {0.1F, 0.26F, 0.6F}));
  EXPECT_TRUE(stops({0.35, 0.8}, {0.25F, 0.16F, 0.6F}));
}

TEST(SafetyGuard, TurningAndMovingAwayAreAlwaysAllowed) {
  EXPECT_FALSE(stops({0.0, 0.8}, {0.23F, 0.0F, 0.6F}));
  EXPECT_FALSE(stops({-0.2, 0.0}, {0.21F, 0.0F, 0.6F}));
}

TEST(SafetyGuard, IgnoresTheFloorAndWhatIsAbove) {
  EXPECT_FALSE(stops({0.35, 0.0}, {0.3F, 0.0F, 0.0F}));
  EXPECT_FALSE(stops({0.35, 0.0}, {0.3F, 0.0F, 1.2F}));
}

}  // namespace
}  // namespace enfilade::explorer
