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

TEST(OdomBoot, IsOneInAComposedRun) { EXPECT_EQ(odom_boot_of("", 1000), 1u); }

}  // namespace
}  // namespace enfilade::motor_control
