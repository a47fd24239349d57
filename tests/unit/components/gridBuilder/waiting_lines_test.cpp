// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/waiting_lines.hpp"

#include <gtest/gtest.h>

#include "components/gridBuilder/core/line_placement.hpp"

namespace enfilade::grid_builder {
namespace {

PointCloud cloud(StampNs stamp_ns, std::size_t points) {
  return {stamp_ns, "base_link", std::vector<Point3f>(points)};
}

TEST(WaitingLines, JoinsTheTwoCloudsOfALine) {
  WaitingLines lines(10);
  lines.add_hits(cloud(1, 3));
  lines.add_hits(cloud(2, 4));
  lines.add_free_ends(cloud(1, 5));
  const BaseLine first = lines.pop();
  EXPECT_EQ(first.stamp_ns, 1);
  EXPECT_EQ(first.hits.size(), 3u);
  EXPECT_EQ(first.free_ends.size(), 5u);
  EXPECT_EQ(lines.pop().hits.size(), 4u);
  EXPECT_EQ(lines.front(), nullptr);
}

TEST(WaitingLines, GivesUpTheOldestWhenTooManyWait) {
  WaitingLines lines(2);
  for (StampNs stamp = 1; stamp <= 5; ++stamp) lines.add_hits(cloud(stamp, 1));
  EXPECT_EQ(lines.overflowed(), 3u);
  EXPECT_EQ(lines.front()->stamp_ns, 4);
}

TEST(LinePlacement, TurnsAndShiftsPointsAndSensorButKeepsHeights) {
  const ScanLine placed = place({9, true, {{1.0F, 0.0F, 0.5F}}, {{0.0F, 1.0F, 2.0F}}}, {0.1F, 0.0F, 0.6F},
                                {10.0, 20.0, 0.5 * kPi});
  EXPECT_EQ(placed.stamp_ns, 9);
  EXPECT_FLOAT_EQ(placed.hits[0].x_m, 10.0F);
  EXPECT_FLOAT_EQ(placed.hits[0].y_m, 21.0F);
  EXPECT_EQ(placed.hits[0].z_m, 0.5F);
  EXPECT_FLOAT_EQ(placed.free_ends[0].x_m, 9.0F);
  EXPECT_FLOAT_EQ(placed.origin.y_m, 20.1F);
  EXPECT_EQ(placed.origin.z_m, 0.6F);
}

}  // namespace
}  // namespace enfilade::grid_builder
