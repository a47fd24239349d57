// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/paper_doors.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/roomDetector/core/room_detector.hpp"

namespace enfilade::room_detector {
namespace {

constexpr double kResolution_m = 0.05;
constexpr WallInterval kDoor{0, 0.7, 1.6};

bool is_in_door(const Rectangle& room, const Point2& q) {
  const double along_m = q.y() + 0.5 * room.height_m;
  return q.x() > 0.0 && along_m > kDoor.from_m && along_m < kDoor.to_m;
}

/// The grid of a room at any yaw, walls 0.07 m thick behind its rectangle, free inside, the door unexplored.
GridChange grid_of(const Rectangle& room) {
  GridChange change{.sequence = 1, .resolution_m = kResolution_m};
  for (std::int16_t x = -70; x < 70; ++x) {
    for (std::int16_t y = -70; y < 70; ++y) {
      const Point2 centre = kResolution_m * Point2(x + 0.5, y + 0.5);
      if (!room.contains(centre, -0.07)) continue;
      const bool is_inside = room.contains(centre);
      if (!is_inside && is_in_door(room, room.pose().inverse() * centre)) continue;
      for (std::int16_t z = 0; z < 50; ++z)
        change.cells.push_back({x, y, z, is_inside ? CellState::kFree : CellState::kOccupied});
    }
  }
  return change;
}

/// Returns from the very walls.
ScanHits hits_of(const Rectangle& room) {
  ScanHits hits{.T_zone_base = room.pose()};
  for (int wall = 0; wall < 4; ++wall) {
    for (double s = 0.01; s < room.wall_length_m(wall); s += 0.02) {
      if (wall == kDoor.wall && s > kDoor.from_m && s < kDoor.to_m) continue;
      const Point2 p = room.corner(wall) + s * room.wall(wall).direction();
      for (const float z : {1.0F, 1.5F, 2.0F, 2.3F})
        hits.hits.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), z, 1});
    }
  }
  return hits;
}

TEST(PaperDoors, LieInTheRefinedWallsWhateverTheirNames) {
  for (const double yaw_deg : {-45.1, -44.9, 0.3, 44.9, 45.1, 135.1}) {
    const Rectangle room{radians(yaw_deg), 0.1, -0.2, 4.0, 3.0};
    RoomDetector detector({.doors = DoorMethod::kPaper});
    detector.clear(kResolution_m);
    detector.update(grid_of(room));
    detector.add_hits(hits_of(room));
    const auto d = detector.estimate(room.pose());
    ASSERT_TRUE(d.estimate.found) << yaw_deg;
    ASSERT_TRUE(d.diagnostics.fit) << yaw_deg;
    EXPECT_GT(iou(d.estimate.rectangle, room), 0.98) << yaw_deg;
    ASSERT_EQ(d.estimate.doors.size(), 1u) << yaw_deg;
    const Segment seen = segment_of(d.estimate.rectangle, d.estimate.doors[0].gap),
                  real = segment_of(room, kDoor);
    EXPECT_LT((seen.from - real.from).norm(), 0.1) << yaw_deg;
    EXPECT_LT((seen.to - real.to).norm(), 0.1) << yaw_deg;
  }
}

TEST(PaperDoors, EndNoLaterThanTheRefinedWall) {
  const Rectangle coarse{radians(-44.0), 0.0, 0.0, 4.0, 3.0}, refined{radians(46.0), 0.0, 0.0, 2.9, 3.9};
  const auto doors = rename_walls({{.gap = {0, 2.0, 3.0}}, {.gap = {3, 0.0, 1.0}}}, coarse, refined);
  ASSERT_EQ(doors.size(), 2u);
  EXPECT_EQ(doors[0].gap.wall, 2);
  EXPECT_EQ(doors[0].gap.from_m, 0.0);
  EXPECT_NEAR(doors[0].gap.to_m, 0.95, 1e-9);
  EXPECT_EQ(doors[1].gap.wall, 3);
  EXPECT_NEAR(doors[1].gap.from_m, 1.95, 1e-9);
  EXPECT_NEAR(doors[1].gap.to_m, 2.9, 1e-9);
}

}  // namespace
}  // namespace enfilade::room_detector
