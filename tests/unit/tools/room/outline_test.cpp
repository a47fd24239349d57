// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "tools/room/outline_choice.hpp"
#include "tools/room/outline_sight.hpp"

namespace enfilade::room {
namespace {

/// What stands in a plane: sides of boxes, and no more.
struct PlanarWorld {
  struct Wall {
    Point2 from, to;
  };
  std::vector<Wall> walls;

  void wall(const Point2& from, const Point2& to) { walls.push_back({from, to}); }
  void box(double x0, double y0, double x1, double y1) {
    wall({x0, y0}, {x1, y0});
    wall({x1, y0}, {x1, y1});
    wall({x1, y1}, {x0, y1});
    wall({x0, y1}, {x0, y0});
  }
  std::optional<double> range(const Point2& place, const Point2& direction) const {
    std::optional<double> nearest;
    for (const Wall& w : walls) {
      const Point2 along = w.to - w.from, to = w.from - place;
      const double cross = direction.x() * along.y() - direction.y() * along.x();
      const double range_m = (to.x() * along.y() - to.y() * along.x()) / cross;
      const double share = (to.x() * direction.y() - to.y() * direction.x()) / cross;
      if (range_m > 0.0 && share >= 0.0 && share <= 1.0 && range_m < nearest.value_or(16.0))
        nearest = range_m;
    }
    return nearest;
  }
  Panorama seen_from(const Point2& place) const {
    Panorama panorama{.place = place};
    for (int i = 0; i < 720; ++i) {
      const double angle = 2.0 * kPi * i / 720 + 1e-4;
      const Point2 direction(std::cos(angle), std::sin(angle));
      const auto met_m = range(place, direction);
      panorama.sights.push_back({direction, met_m.value_or(16.0), met_m.has_value()});
    }
    return panorama;
  }
};

/// x from 0 to 6 m, y from 0 to 4 m, with a door in the upper wall from 2 to 3 m.
PlanarWorld room() {
  PlanarWorld world;
  world.wall({0.0, 0.0}, {6.0, 0.0});
  world.wall({6.0, 0.0}, {6.0, 4.0});
  world.wall({0.0, 4.0}, {0.0, 0.0});
  world.wall({2.0, 4.0}, {0.0, 4.0});
  world.wall({6.0, 4.0}, {3.0, 4.0});
  return world;
}

const Rectangle kRoom{0.0, 3.0, 2.0, 6.0, 4.0};

TEST(OutlineSight, MeasuresTheDoorOfARoom) {
  const OutlineSight seen = sight_of(kRoom, room().seen_from({2.0, 1.5}));
  EXPECT_NEAR(seen.open_m, 1.0, 0.15);
  EXPECT_NEAR(seen.seen_shares, 4.0 - 1.0 / 6.0, 0.05);
  EXPECT_EQ(seen.narrow_gaps, 0.0);
  EXPECT_EQ(seen.bare_walls, 0.0);
  EXPECT_NEAR(seen.hidden_m, 0.0, 0.05);
}

TEST(OutlineSight, TurnsWithTheWorld) {
  const Pose2 turn{1.0, -2.0, 0.6};
  PlanarWorld turned = room();
  for (auto& wall : turned.walls) wall = {turn * wall.from, turn * wall.to};
  const double before = implausibility(sight_of(kRoom, room().seen_from({2.0, 1.5})));
  EXPECT_NEAR(implausibility(sight_of(turn * kRoom, turned.seen_from(turn * Point2(2.0, 1.5)))), before, 0.1);
}

TEST(OutlineSight, TakesWhatANarrowThingHidesForWhatIsBesideIt) {
  PlanarWorld world = room();
  world.box(4.0, 1.9, 4.1, 2.0);
  EXPECT_NEAR(sight_of(kRoom, world.seen_from({2.0, 1.5})).hidden_m, 0.0, 0.05);
  world.box(4.0, 1.0, 5.0, 3.0);
  EXPECT_GT(sight_of(kRoom, world.seen_from({2.0, 1.5})).hidden_m, 1.0);
}

TEST(OutlineSight, CountsWhatStandsCloselyBehindTheOutline) {
  const Rectangle in_front{0.0, 2.75, 2.0, 5.5, 4.0};  // half a metre before the right wall
  EXPECT_NEAR(sight_of(in_front, room().seen_from({2.0, 1.5})).niches_m, 4.0, 0.5);
  EXPECT_NEAR(sight_of(kRoom, room().seen_from({2.0, 1.5})).niches_m, 0.0, 0.05);
}

TEST(OutlineSight, FindsNothingKnownOfAWallThatIsHidden) {
  PlanarWorld world = room();
  world.wall({5.0, 0.0}, {5.0, 4.0});
  EXPECT_NEAR(sight_of(kRoom, world.seen_from({2.0, 1.5})).bare_walls, 1.0, 0.01);
}

TEST(OutlineChoice, TakesTheRoomAndNotTheStripBeforeARowOfChairs) {
  PlanarWorld world = room();
  for (double x = 0.4; x < 6.0; x += 0.8) world.box(x, 1.4, x + 0.3, 1.5);
  const Rectangle strip{0.0, 3.0, 0.7, 6.0, 1.4};
  const auto chosen = choose_outline({strip, kRoom}, world.seen_from({1.0, 0.6}), {.side_min_m = 1.2});
  ASSERT_TRUE(chosen);
  EXPECT_GT(iou(*chosen, kRoom), 0.95);
}

TEST(OutlineChoice, FindsTheWallThatNoSeedHas) {
  const Rectangle wide{0.0, 3.0, 4.0, 6.0, 8.0};  // through the door, as far as what stands there
  PlanarWorld world = room();
  world.wall({0.0, 8.0}, {6.0, 8.0});
  const auto chosen = choose_outline({wide}, world.seen_from({2.0, 1.5}), {});
  ASSERT_TRUE(chosen);
  EXPECT_GT(iou(*chosen, kRoom), 0.95);
}

TEST(OutlineChoice, KeepsTheLimitsAndHasNothingWithoutSeeds) {
  EXPECT_FALSE(choose_outline({}, room().seen_from({2.0, 1.5}), {}));
  const Rectangle seed{0.0, 2.5, 1.0, 5.0, 2.0};
  EXPECT_EQ(*choose_outline({seed}, room().seen_from({2.0, 1.5}), {.side_max_m = 3.9}), seed);
}

}  // namespace
}  // namespace enfilade::room
