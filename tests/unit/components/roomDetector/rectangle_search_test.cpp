// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/rectangle_search.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/roomDetector/brute_force.hpp"

namespace enfilade::room_detector {
namespace {

using test::RandomWorld;

HoughSpace space_of(const HoughConfig& config, const std::vector<Vote>& votes,
                    const Penalties& penalties = {}) {
  HoughSpace space(config, Point2(0.1, -0.2));
  for (std::size_t i = 0; i < votes.size(); ++i) space.set(i, votes[i]);
  space.set_penalties(penalties);
  return space;
}

/// What the paper counts: nothing but occupied cells.
std::vector<Vote> occupied_only(std::vector<Vote> votes) {
  for (Vote& vote : votes) vote.free = vote.interior = 0;
  return votes;
}

struct Case {
  HoughConfig hough{.theta_step_deg = 9.0, .step_m = 0.5, .range_m = 4.0};
  SearchConfig search{.side_min_m = 1.0, .side_max_m = 6.0, .max_expansions = 1'000'000};
  std::optional<Point2> robot;
  std::vector<Vote> votes;

  explicit Case(unsigned seed) {
    RandomWorld world(seed);
    hough.theta_step_deg = world.uniform(9.0, 20.0);
    search.side_min_m = world.uniform(0.3, 2.0);
    search.side_max_m = world.uniform(2.5, 7.0);
    if (world.integer(0, 1)) robot = Point2(world.uniform(-1.5, 1.5), world.uniform(-1.5, 1.5));
    votes = world.votes(4.5, 0.3);
  }
};

TEST(RectangleSearch, FindsTheArgmaxOfThePapersTable) {
  for (unsigned seed = 0; seed < 320; ++seed) {
    const Case c(seed);
    const HoughSpace space = space_of(c.hough, occupied_only(c.votes));
    const test::LiteralHough literal(space);
    const auto truth =
        test::argmax(space, c.search, c.robot, [&](const BinRectangle& r) { return literal.score(r); });
    const auto found = RectangleSearch(c.search).find_best(space, c.robot);
    ASSERT_EQ(found.has_value(), truth.has_value()) << "seed " << seed;
    if (!truth) continue;
    EXPECT_EQ(found->score, truth->score) << "seed " << seed;
    EXPECT_EQ(found->rectangle, truth->rectangle) << "seed " << seed;
    EXPECT_EQ(found->gap, 0);
  }
}

TEST(RectangleSearch, FindsTheArgmaxOfTheEvidenceScore) {
  for (unsigned seed = 1000; seed < 1060; ++seed) {
    Case c(seed);
    c.hough.theta_step_deg = 20.0;
    RandomWorld world(seed + 1);
    c.search.side_min_m = std::max(c.search.side_min_m, 1.5);  // three bins: room for the margin
    const HoughSpace space =
        space_of(c.hough, c.votes,
                 {world.uniform(0.0, 1.0), world.integer(0, 3), world.integer(0, 2), world.integer(0, 1)});
    std::vector<test::DirectPlane> planes;
    for (int a = 0; a < space.lattice().angles(); ++a) planes.emplace_back(space, a);
    const auto truth = test::argmax(space, c.search, c.robot, [&](const BinRectangle& r) {
      return planes[static_cast<std::size_t>(r.alpha)].score(r);
    });
    const auto found = RectangleSearch(c.search).find_best(space, c.robot);
    ASSERT_EQ(found.has_value(), truth.has_value()) << "seed " << seed;
    if (!truth) continue;
    EXPECT_EQ(found->score, truth->score) << "seed " << seed;
    EXPECT_EQ(found->rectangle, truth->rectangle) << "seed " << seed;
  }
}

/// O(A N² W): every pair (d12, d34) of every plane, each with its line search, and no bounds.
std::optional<test::Scored> exhaustive(const HoughSpace& space, const SearchConfig& config) {
  std::optional<test::Scored> best;
  const double step = space.lattice().step_m();
  const int n = space.lattice().bins(), least = static_cast<int>(std::ceil(config.side_min_m / step - 1e-9)),
            most = static_cast<int>(std::floor(config.side_max_m / step + 1e-9));
  HoughPlane plane;
  for (int a = 0; a < space.lattice().angles(); ++a) {
    plane.build(space, a);
    for (int d12 = 0; d12 < n; ++d12) {
      for (int d34 = d12 + least; d34 < n && d34 <= d12 + most; ++d34) {
        for (int d41 = 0; d41 < n; d41 += 1) {
          for (int d23 = d41 + least; d23 < n && d23 <= d41 + most; ++d23) {
            const BinRectangle r{a, d12, d34, d41, d23};
            const int score = plane.score(r);
            if (!best || score > best->score) best = test::Scored{r, score};
          }
        }
      }
    }
  }
  return best;
}

TEST(RectangleSearch, AgreesWithExhaustionAtMidSize) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    Case c(seed + 77);
    c.hough = {.theta_step_deg = 18.0, .step_m = 0.16, .range_m = 4.0};
    const HoughSpace space = space_of(c.hough, c.votes, {0.3, 1});
    const auto truth = exhaustive(space, c.search);
    const auto found = RectangleSearch(c.search).find_best(space, std::nullopt);
    ASSERT_TRUE(found && truth);
    EXPECT_EQ(found->score, truth->score) << "seed " << seed;
    EXPECT_EQ(found->rectangle, truth->rectangle) << "seed " << seed;
  }
}

TEST(HoughPlane, ScoreIsTheNumberOfPointsOnTheContour) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Case c(seed + 500);
    const HoughSpace space = space_of(c.hough, occupied_only(c.votes));
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

TEST(RectangleSearch, GivesUpProvingWithinItsBudgetAndStatesTheGap) {
  RandomWorld world(3);
  std::vector<Vote> noise;
  for (int i = 0; i < 4000; ++i)
    noise.push_back({{world.uniform(-8, 8), world.uniform(-8, 8)}, world.integer(1, 4), 0, 0});
  const HoughSpace space = space_of({.theta_step_deg = 5.0, .step_m = 0.1, .range_m = 8.0}, noise);
  SearchConfig config{.max_expansions = 2000};
  const auto hasty = RectangleSearch(config).find_best(space, std::nullopt);
  ASSERT_TRUE(hasty);
  EXPECT_GT(hasty->gap, 0);
  EXPECT_LE(hasty->expansions, config.max_expansions + 3 * space.lattice().bins() + 1);
  config.max_expansions = 1 << 30;
  const auto best = RectangleSearch(config).find_best(space, std::nullopt);
  EXPECT_EQ(best->gap, 0);
  EXPECT_LE(best->score, hasty->score + hasty->gap);
  EXPECT_GE(best->score, hasty->score);
}

}  // namespace
}  // namespace enfilade::room_detector
