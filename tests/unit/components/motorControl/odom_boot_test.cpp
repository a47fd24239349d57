// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/node/odom_boot.hpp"

#include <gtest/gtest.h>

namespace enfilade::motor_control {
namespace {

TEST(OdomBoot, DiffersBetweenProcessesAndBetweenStarts) {
  EXPECT_NE(odom_boot_of("4711", 1000), odom_boot_of("4712", 1000));
  EXPECT_NE(odom_boot_of("4711", 1000), odom_boot_of("4711", 2000));
  EXPECT_EQ(odom_boot_of("4711", 1000), odom_boot_of("4711", 1000));
}

TEST(OdomBoot, DependsOnTheTimeAloneInAComposedRun) {
  EXPECT_EQ(odom_boot_of("", 0), 1u);
  EXPECT_EQ(odom_boot_of("", from_seconds(47.5)), 476u);
}

}  // namespace
}  // namespace enfilade::motor_control
