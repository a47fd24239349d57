// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/around_search.hpp"

#include <gtest/gtest.h>

#include "tests/unit/components/roomDetector/brute_force.hpp"

namespace enfilade::room_detector {
namespace {

using test::RandomWorld;

/// A robot in a random world of 64 × 64 bins.
struct World {
  HoughConfig hough{.theta_step_deg = 30.0, .step_m = 0.125, .range_m = 4.0};
  SearchConfig config{.side_min_m = 0.9, .side_max_m = 5.0, .least_score = -1'000'000};
  Point2 robot;
  std::vector<Vote> votes;
  Penalties penalties;

  explicit World(unsigned seed) {
    RandomWorld world(seed);
    robot = {world.uniform(-1.5, 1.5), world.uniform(-1.5, 1.5)};
    votes = world.votes(4.5, 0.1);
    for (Vote& vote : votes) vote.interior *= world.integer(0, 8);
    if (seed % 4) penalties = {world.uniform(0.2, 2.0), world.integer(0, 3), world.integer(0, 2), 1};
  }

  HoughSpace space(double cell_m) const {
    HoughSpace space(hough, Point2(0.1, -0.2), cell_m);
    space.set_penalties(penalties);
    for (std::size_t i = 0; i < votes.size(); ++i) space.set(i, votes[i]);
    return space;
  }
};

Incumbent found_by(AroundSearch& search, const World& world, const HoughSpace& space) {
  Incumbent best{.rectangle = {},
                 .score = world.config.least_score - 1,
                 .max_expansions = std::numeric_limits<int>::max()};
  WindowLimits sides;
  sides.min_gap = static_cast<int>(std::ceil(world.config.side_min_m / world.hough.step_m - 1e-9));
  sides.max_gap = static_cast<int>(std::floor(world.config.side_max_m / world.hough.step_m + 1e-9));
  search.search(space, world.robot, sides, best);
  return best;
}

void expect_argmax(AroundSearch& search, const World& world, const HoughSpace& space, unsigned seed) {
  const Incumbent found = found_by(search, world, space);
  const auto truth = test::Exhaustion(space, world.config, world.robot).argmax();
  ASSERT_TRUE(truth);
  EXPECT_EQ(found.score, truth->score) << "seed " << seed;
  EXPECT_EQ(found.rectangle, truth->rectangle) << "seed " << seed;
  EXPECT_LT(found.gap_bound, found.score);
}

TEST(AroundSearch, FindsTheArgmaxHoweverFarVotesAreCountedAtFirst) {
  for (const int near_bins : {CornerBounds::kBlock, 2 * CornerBounds::kBlock, 64}) {
    AroundSearch search({near_bins});
    for (unsigned seed = 0; seed < 60; ++seed) {
      const World world(seed);
      expect_argmax(search, world, world.space(world.hough.step_m), seed);
    }
  }
}

TEST(AroundSearch, FindsTheArgmaxAmongMuchThatSpeaksAgainstIt) {
  AroundSearch search({CornerBounds::kBlock});
  std::vector<unsigned> seeds{19'580};  // what lies inside must not be charged to a bound that knows of it
  for (unsigned seed = 0; seed < 150; ++seed) seeds.push_back(seed);
  for (const unsigned seed : seeds) {
    World world(seed);
    RandomWorld factors(seed);
    const int wall = factors.integer(1, 10), inside = factors.integer(1, 40);
    for (Vote& vote : world.votes) {
      vote.occupied *= wall;
      vote.interior *= inside;
    }
    expect_argmax(search, world, world.space(world.hough.step_m), seed);
  }
}

TEST(AroundSearch, FindsTheFirstOfManyEqualRectanglesWhereOnlyVotesCount) {
  AroundSearch search({CornerBounds::kBlock});
  for (unsigned seed = 0; seed < 300; ++seed) {
    World world(seed);
    world.penalties = {};
    if (seed % 3 > 0) world.votes.resize(seed % 3 * 8 + seed % 7);  // else there are more than a few
    if (seed % 5 == 0) world.config.side_min_m = world.config.side_max_m = 2.5;
    for (Vote& vote : world.votes) vote.interior = 0;
    expect_argmax(search, world, world.space(world.hough.step_m), seed);
  }
}

TEST(AroundSearch, FindsTheArgmaxOfVotesThatDoNotFit16Bits) {
  AroundSearch search({CornerBounds::kBlock});
  for (unsigned seed = 0; seed < 30; ++seed) {
    World world(seed);
    RandomWorld factors(seed);
    for (Vote& vote : world.votes) vote.occupied *= factors.integer(500, 1500);
    expect_argmax(search, world, world.space(world.hough.step_m), seed);
    expect_argmax(search, world, world.space(0.05 * world.hough.step_m), seed);  // hundreds of cells a bin
  }
}

/// Distances of the sides of `r` from the robot's bin, outward.
std::array<int, 4> distances(const BinRectangle& r, const HoughSpace::Bins& robot) {
  return {robot.d - r.d12, r.d34 - robot.d, robot.p - r.d41, r.d23 - robot.p};
}

bool holds(const CornerChoice& choice, const std::array<int, 4>& away) {
  std::array<int, 4> block;
  for (int s = 0; s < 4; ++s) {
    const auto at = std::ranges::find_if(
        choice.blocks[s], [&](const LineBlock& b) { return b.nearest <= away[s] && away[s] <= b.farthest; });
    if (at == choice.blocks[s].end()) return false;
    block[s] = static_cast<int>(at - choice.blocks[s].begin());
  }
  const auto may = [&](int d, int p) { return choice.may(d, p, block[d], block[kD41 + p]); };
  return may(0, 0) && may(0, 1) && may(1, 0) && may(1, 1);
}

/// The bounds of the plane that holds the argmax, asked for just its score.
void expect_bounded(const World& world, int near_bins, bool are_rounded, unsigned seed) {
  const HoughSpace space = world.space(world.hough.step_m);
  const auto truth = test::Exhaustion(space, world.config, world.robot).argmax();
  ASSERT_TRUE(truth);
  const int angle = truth->rectangle.alpha, last = space.lattice().bins() - 1;
  const auto robot = space.bins_of(angle, world.robot);
  const Reaches reaches{robot.d, last - robot.d, robot.p, last - robot.p};
  int most = 0;
  for (const int sum : space.sums_by_d(angle)) most = std::max(most, sum);
  for (const int sum : space.sums_by_p(angle)) most = std::max(most, sum);
  NearVotes votes;
  votes.gather(space, world.robot, last, most);
  EXPECT_EQ(votes.scale_bits() > 0, are_rounded);
  CornerBounds bounds;
  const PlaneLimits limits{{.min_gap = 8, .max_gap = 40}, {.min_gap = 8, .max_gap = 40}};
  CornerChoice choice = CornerBounds::everything(reaches, near_bins);
  for (const char* const stage : {"by blocks", "in detail"}) {
    bounds.lay_out(space, votes, choice);
    bounds.build(space, angle, robot, truth->score, 4 * most, limits);
    EXPECT_GE(bounds.bound(), truth->score) << stage << ", seed " << seed;
    EXPECT_TRUE(holds(bounds.choice(), distances(truth->rectangle, robot))) << stage << ", seed " << seed;
    choice = bounds.choice().cut(CornerBounds::kBlock);
  }
}

TEST(CornerBounds, KeepTheCornersOfTheArgmaxWhenAskedForItsScore) {
  for (const int near_bins : {CornerBounds::kBlock, 2 * CornerBounds::kBlock, 64}) {
    for (unsigned seed = 0; seed < 120; ++seed) expect_bounded(World(seed), near_bins, false, seed);
  }
}

TEST(CornerBounds, KeepThemWhereVotesAreRounded) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    World world(seed);
    for (Vote& vote : world.votes) vote.occupied = vote.occupied > 0 ? 15 : 0;
    world.votes.push_back({world.robot + Point2(0.0, 3.0), 200'000, 0, 0});  // units of 16
    expect_bounded(world, CornerBounds::kBlock, true, seed);
  }
}

TEST(AroundSearch, NeedsLessWorkWithAGoodFirstGuess) {
  const World world(7);
  const HoughSpace space = world.space(world.hough.step_m);
  AroundSearch search;
  const Incumbent anew = found_by(search, world, space);
  Incumbent known = anew;
  known.expansions = 0;
  WindowLimits sides{.min_gap = 8, .max_gap = 40};
  search.search(space, world.robot, sides, known);
  EXPECT_EQ(known.rectangle, anew.rectangle);
  EXPECT_LE(known.expansions, anew.expansions);
}

}  // namespace
}  // namespace enfilade::room_detector
