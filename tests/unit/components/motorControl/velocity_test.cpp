// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "components/motorControl/core/command_watchdog.hpp"
#include "components/motorControl/core/velocity_limiter.hpp"

namespace enfilade::motor_control {
namespace {

constexpr double kStep_s = 0.02;
const VelocityLimiterConfig kLimits{};

TEST(VelocityLimiter, NeverExceedsSpeedOrAcceleration) {
  VelocityLimiter limiter(kLimits);
  VelocityCommand before;
  for (int i = 0; i < 400; ++i) {
    const VelocityCommand target{(i / 60) % 2 ? -9.0 : 9.0, (i / 35) % 2 ? 7.0 : -7.0};
    const VelocityCommand now = limiter.step(target, kStep_s, Slowing::kSmooth);
    EXPECT_LE(std::abs(now.linear_m_s), kLimits.max_linear_m_s + 1e-12);
    EXPECT_LE(std::abs(now.angular_rad_s), kLimits.max_angular_rad_s + 1e-12);
    EXPECT_LE(std::abs(now.linear_m_s - before.linear_m_s), kLimits.deceleration_m_s2 * kStep_s + 1e-12);
    EXPECT_LE(std::abs(now.angular_rad_s - before.angular_rad_s),
              kLimits.deceleration_rad_s2 * kStep_s + 1e-12);
    before = now;
  }
}

TEST(VelocityLimiter, ReachesATargetWithinTheLimitsAndStays) {
  VelocityLimiter limiter(kLimits);
  for (int i = 0; i < 100; ++i) limiter.step({0.4, -0.9}, kStep_s, Slowing::kSmooth);
  EXPECT_EQ(limiter.speed(), (VelocityCommand{0.4, -0.9}));
}

TEST(VelocityLimiter, KeepsTheCurveOfATargetBeyondTheLimits) {
  VelocityLimiter limiter(kLimits);
  for (int i = 0; i < 200; ++i) limiter.step({1.0, 0.5}, kStep_s, Slowing::kSmooth);
  EXPECT_NEAR(limiter.speed().linear_m_s, 0.5, 1e-12);
  EXPECT_NEAR(limiter.speed().angular_rad_s, 0.25, 1e-12);
}

TEST(VelocityLimiter, ATargetThatIsNoNumberMeansStand) {
  VelocityLimiter limiter(kLimits);
  limiter.step({0.4, 0.0}, kStep_s, Slowing::kSmooth);
  for (int i = 0; i < 10; ++i)
    limiter.step({std::numeric_limits<double>::quiet_NaN(), 1.0}, kStep_s, Slowing::kSmooth);
  EXPECT_EQ(limiter.speed(), VelocityCommand{});
}

TEST(VelocityLimiter, BrakesFromFullSpeedInThreeControlPeriods) {
  VelocityLimiter limiter(kLimits);
  for (int i = 0; i < 200; ++i) limiter.step({0.5, 1.2}, kStep_s, Slowing::kSmooth);
  for (int i = 0; i < 3; ++i) limiter.step({}, kStep_s, Slowing::kBrake);
  EXPECT_EQ(limiter.speed(), VelocityCommand{});
}

TEST(VelocityLimiter, RefusesALimitOfZero) {
  EXPECT_THROW(VelocityLimiter({.brake_m_s2 = 0.0}), std::invalid_argument);
}

TEST(CommandWatchdog, FollowsACommandUntilItIsStale) {
  CommandWatchdog watchdog({.stale_after_s = 0.2});
  EXPECT_FALSE(watchdog.command(0));
  watchdog.take({0.3, 0.1}, from_seconds(1.0));
  EXPECT_EQ(watchdog.command(from_seconds(1.2)), (VelocityCommand{0.3, 0.1}));
  EXPECT_FALSE(watchdog.command(from_seconds(1.201)));
  watchdog.take({0.2, 0.0}, from_seconds(1.3));
  EXPECT_EQ(watchdog.command(from_seconds(1.35)), (VelocityCommand{0.2, 0.0}));
}

TEST(CommandWatchdog, AClockThatRanBackwardsMakesTheCommandStale) {
  CommandWatchdog watchdog({.stale_after_s = 0.2});
  watchdog.take({0.3, 0.1}, from_seconds(50.0));
  EXPECT_FALSE(watchdog.command(from_seconds(1.0)));
}

}  // namespace
}  // namespace enfilade::motor_control
