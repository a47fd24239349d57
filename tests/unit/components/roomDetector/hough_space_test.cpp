// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/hough_space.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "tests/unit/components/roomDetector/brute_force.hpp"

namespace enfilade::room_detector {
namespace {

using test::RandomWorld;

HoughSpace random_space(unsigned seed, const Penalties& penalties) {
  RandomWorld world(seed);
  HoughSpace space({.theta_step_deg = 15.0, .step_m = 0.5, .range_m = 4.0}, Point2(0.1, -0.2), 0.5);
  const auto votes = world.votes(4.5, 0.3);
  for (std::size_t i = 0; i < votes.size(); ++i) space.set(i, votes[i]);
  space.set_penalties(penalties);
  return space;
}

TEST(HoughPlane, ScoreIsTheNumberOfPointsOnTheContour) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const HoughSpace space = random_space(seed, {.contour_bins = 9});
    HoughPlane plane;
    for (int a = 0; a < space.lattice().angles(); ++a) {
      plane.build(space, a);
      const BinRectangle r{a, 3, 11, 2, 9};
      int counted = 0;
      for (const Vote& vote : space.votes()) {
        const auto b = space.bins_of(a, vote.position);
        const bool within = b.d >= r.d12 && b.d <= r.d34 && b.p >= r.d41 && b.p <= r.d23;
        const bool inside = b.d > r.d12 && b.d < r.d34 && b.p > r.d41 && b.p < r.d23;
        if (within && !inside) counted += vote.occupied;
      }
      EXPECT_EQ(plane.score(r), counted);
    }
  }
}

TEST(HoughSpace, CountsARectangleVoteByVoteAsBinByBin) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const HoughSpace space = random_space(seed, {0.7, 2, 1, 1});
    for (int a = 0; a < space.lattice().angles(); ++a) {
      const BinRectangle r{a, 2, 10, 5, 12};
      const test::DirectPlane direct(space, a);
      EXPECT_EQ(space.score(r), direct.score(r));
      const auto walls = space.walls(r);
      int on_walls = 0;
      for (int p = r.d41; p < r.d23; ++p) on_walls += direct.weight(r.d12, p);
      EXPECT_EQ(walls[0], on_walls);
      int contour = 0;
      for (int d = r.d12; d <= r.d34; ++d) contour += direct.weight(d, r.d41) + direct.weight(d, r.d23);
      for (int p = r.d41 + 1; p < r.d23; ++p) contour += direct.weight(r.d12, p) + direct.weight(r.d34, p);
      EXPECT_EQ(std::accumulate(walls.begin(), walls.end(), 0), contour);
    }
  }
}

TEST(FreeMap, ChargesForFreeSpaceAwayFromAnythingOccupied) {
  FreeMap map(0.1, Point2(3.0, -2.0), 2.0);
  map.set_rule(0.5, 1);
  const auto charge = [&](double x, double y) {
    return map.charge_at(static_cast<std::int32_t>(map.fixed_x(x)),
                         static_cast<std::int32_t>(map.fixed_y(y)));
  };
  map.add({3.05, -1.95}, 8, 0);
  map.add({3.25, -1.95}, 6, 0);
  EXPECT_EQ(charge(3.01, -1.91), 4);
  EXPECT_EQ(charge(3.25, -1.95), 3);
  EXPECT_EQ(charge(3.15, -1.95), 0);
  map.add({3.35, -1.85}, 0, 1);
  EXPECT_EQ(charge(3.25, -1.95), 0);  // noise of the wall beside it
  EXPECT_EQ(charge(3.05, -1.95), 4);
  map.add({3.35, -1.85}, 0, -1);
  EXPECT_EQ(charge(3.25, -1.95), 3);
}

TEST(FreeMap, BoundsTheChargesAroundAPointFromBelow) {
  RandomWorld world(5);
  FreeMap map(0.1, Point2::Zero(), 3.0);
  map.set_rule(1.0, 1);
  for (double x = -2.95; x < 3.0; x += 0.1) {
    for (double y = -2.95; y < 3.0; y += 0.1) map.add({x, y}, world.integer(3, 9), world.integer(0, 60) == 0);
  }
  const auto fixed = [](double value) { return static_cast<std::int32_t>(value); };
  for (const double distance : {0.1, 0.25, 0.4}) {
    int bounded = 0;
    for (int i = 0; i < 300; ++i) {
      const Point2 at(world.uniform(-2.0, 2.0), world.uniform(-2.0, 2.0));
      const FreeMap::Least least_of = map.least_within(distance);
      const int least = least_of.at(fixed(map.fixed_x(at.x())), fixed(map.fixed_y(at.y())));
      bounded += least > 0;
      for (int k = 0; k < 50; ++k) {
        const Point2 near =
            at + Point2(world.uniform(-distance, distance), world.uniform(-distance, distance));
        EXPECT_LE(least, map.charge_at(fixed(map.fixed_x(near.x())), fixed(map.fixed_y(near.y()))));
      }
      if (i % 3 == 0) map.add(at, world.integer(-3, 3), 0);
    }
    EXPECT_GT(bounded, 10);
  }
}

}  // namespace
}  // namespace enfilade::room_detector
