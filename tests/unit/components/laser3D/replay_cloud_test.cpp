// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/replay_cloud.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/laser3D/synthetic_room.hpp"

namespace enfilade::laser_3d {
namespace {

TEST(ReplayCloud, LiftsTheFloorToZeroAndKeepsWhatLiesNearItAsFreeSpace) {
  const auto cloud = make_replay_cloud({}, {.points = synthetic_room(1.3), .origin = {}});
  ASSERT_TRUE(cloud);
  EXPECT_NEAR(cloud->scanner_height_m, 1.3, 0.01);
  EXPECT_EQ(cloud->points + cloud->near_floor, synthetic_room(1.3).size());
  float highest_m = 0.0f;
  for (const auto& line : cloud->lines)
    for (const Point3f& p : line) {
      EXPECT_GE(p.z_m, 0.2f);
      highest_m = std::max(highest_m, p.z_m);
    }
  EXPECT_NEAR(highest_m, 2.5, 0.05);
  ASSERT_EQ(cloud->free_ends.size(), cloud->lines.size());
  std::uint64_t free_ends = 0;
  for (const auto& ends : cloud->free_ends) {
    free_ends += ends.size();
    for (const Point3f& p : ends) EXPECT_LT(p.z_m, 0.31f) << "a little before the floor";
  }
  EXPECT_EQ(free_ends, cloud->near_floor);
}

TEST(ReplayCloud, LinesAreFullButTheLast) {
  const auto cloud = make_replay_cloud({.line_points = 1000}, {.points = synthetic_room(1.3), .origin = {}});
  std::size_t points = 0;
  for (std::size_t i = 0; i < cloud->lines.size(); ++i) {
    points += cloud->lines[i].size();
    if (i + 1 == cloud->lines.size()) break;
    EXPECT_EQ(cloud->lines[i].size() + cloud->free_ends[i].size(), 1000u);
  }
  EXPECT_EQ(points, cloud->points);
}

TEST(ReplayCloud, TheRobotStandsUnderTheScannerWhereverTheFramesOriginIs) {
  ScannedPoints moved{.points = synthetic_room(1.3), .origin = {5.0f, -2.0f, 1.0f}};
  for (Point3f& p : moved.points) p = {p.x_m + 5.0f, p.y_m - 2.0f, p.z_m + 1.0f};
  const auto cloud = make_replay_cloud({}, moved);
  const auto plain = make_replay_cloud({}, {.points = synthetic_room(1.3), .origin = {}});
  EXPECT_NEAR(cloud->scanner_height_m, plain->scanner_height_m, 1e-3);
  EXPECT_NEAR(cloud->lines[0][0].x_m, plain->lines[0][0].x_m, 1e-3);
}

TEST(ReplayCloud, IsNothingWithoutAFloor) {
  EXPECT_FALSE(make_replay_cloud({}, {.points = {{1.0f, 1.0f, 1.0f}}, .origin = {}}));
}

}  // namespace
}  // namespace enfilade::laser_3d
