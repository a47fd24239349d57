// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/line_queue.hpp"

#include <gtest/gtest.h>

namespace enfilade::laser_3d {
namespace {

LaserScan line_at(StampNs stamp_ns) {
  LaserScan scan;
  scan.stamp_ns = stamp_ns;
  scan.time_increment_s = 0.001f;
  scan.ranges_m.assign(11, 1.0f);  // 10 ms long
  return scan;
}

TEST(LineQueue, GivesALineAsSoonAsItsLastBeamIsCovered) {
  LineQueue queue{LineQueueConfig{}};
  RollInterpolator roll{RollInterpolatorConfig{}};
  queue.push(line_at(from_seconds(0.002)));
  roll.add(0, 0.0);
  roll.add(from_seconds(0.005), 0.5);
  EXPECT_FALSE(queue.pop(roll));
  roll.add(from_seconds(0.015), 1.5);
  const auto line = queue.pop(roll);
  ASSERT_TRUE(line);
  ASSERT_EQ(line->roll_rad.size(), 11u);
  for (int i = 0; i < 11; ++i) EXPECT_NEAR(line->roll_rad[static_cast<std::size_t>(i)], 0.2 + 0.1 * i, 1e-6);
  EXPECT_FALSE(queue.pop(roll));
  EXPECT_EQ(queue.dropped(), 0u);
}

TEST(LineQueue, DropsTheOldestWhenFullAndCountsIt) {
  LineQueue queue({.capacity = 2});
  for (int i = 0; i < 5; ++i) queue.push(line_at(from_seconds(0.025 * i)));
  EXPECT_EQ(queue.dropped(), 3u);
  RollInterpolator roll{RollInterpolatorConfig{}};
  for (int i = 0; i < 100; ++i) roll.add(from_seconds(0.005 * i), 0.0);
  EXPECT_EQ(queue.pop(roll)->scan.stamp_ns, from_seconds(0.075));
  EXPECT_EQ(queue.pop(roll)->scan.stamp_ns, from_seconds(0.1));
}

TEST(LineQueue, DropsALineWhoseAnglesNeverWillBeKnownAndGoesOn) {
  LineQueue queue{LineQueueConfig{}};
  RollInterpolator roll{RollInterpolatorConfig{}};
  queue.push(line_at(0));
  queue.push(line_at(from_seconds(0.025)));
  for (int i = 1; i < 20; ++i)
    roll.add(from_seconds(0.005 * i), 0.0);  // begins after the first line has begun
  EXPECT_EQ(queue.pop(roll)->scan.stamp_ns, from_seconds(0.025));
  EXPECT_EQ(queue.dropped(), 1u);
}

}  // namespace
}  // namespace enfilade::laser_3d
