// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "components/roomDetector/core/around_search.hpp"
#include "tests/unit/components/roomDetector/brute_force.hpp"

namespace enfilade::room_detector {
namespace {

constexpr int kWorkers = 3;

/// A thread for each worker and list of tasks.
TaskRunner threads() {
  return {.workers = kWorkers, .run = [](int tasks, const TaskRunner::Work& work) {
            std::atomic<int> next = 0;
            std::vector<std::jthread> threads;
            for (int worker = 0; worker < kWorkers; ++worker) {
              threads.emplace_back([&, worker] {
                for (int task = next++; task < tasks; task = next++) work(task, worker);
              });
            }
          }};
}

/// A random world of 64 × 64 bins, with all that `score: evidence` counts.
HoughSpace random_space(unsigned seed) {
  test::RandomWorld world(seed);
  HoughSpace space({.theta_step_deg = 1.0, .step_m = 0.125, .range_m = 4.0}, Point2(0.1, -0.2), 0.05);
  space.set_penalties({world.uniform(0.2, 2.0), world.integer(0, 3), world.integer(0, 2), 1});
  const auto votes = world.votes(4.5, 0.1);
  for (std::size_t i = 0; i < votes.size(); ++i) space.set(i, votes[i]);
  return space;
}

Incumbent found_by(AroundSearch search, const HoughSpace& space, const Point2& robot, int max_expansions) {
  Incumbent best{.rectangle = {}, .score = -1'000'000, .max_expansions = max_expansions};
  WindowLimits sides;
  sides.min_gap = 8;
  sides.max_gap = 40;
  search.search(space, robot, sides, best);
  return best;
}

/// The result of a search on threads from its beginning on, which must be that of one without any.
Incumbent expect_same(unsigned seed, int max_expansions) {
  const Point2 robot(0.3 - 0.1 * seed, 0.2);
  const HoughSpace space = random_space(seed), same = random_space(seed);
  const AroundSearchConfig config{.alone_expansions = 1};
  const Incumbent one = found_by(AroundSearch(config), space, robot, max_expansions),
                  other = found_by(AroundSearch(config, threads()), same, robot, max_expansions);
  EXPECT_EQ(other.rectangle, one.rectangle) << "seed " << seed;
  EXPECT_EQ(other.score, one.score) << "seed " << seed;
  EXPECT_EQ(other.gap_bound, one.gap_bound) << "seed " << seed;
  EXPECT_EQ(other.expansions, one.expansions) << "seed " << seed;
  EXPECT_EQ(other.planes_opened, one.planes_opened) << "seed " << seed;
  return other;
}

TEST(SearchThreads, FindTheSameByTheSameWorkHoweverManyTheyAre) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Incumbent found = expect_same(seed, 1'000'000);
    EXPECT_LT(found.gap_bound, found.score) << "seed " << seed;
    EXPECT_GT(found.expansions, 1) << "seed " << seed << ": nothing was left for threads";
  }
}

TEST(SearchThreads, LeaveTheSameUnprovenWithinABudget) {
  const Incumbent found = expect_same(1, 100);
  EXPECT_GE(found.gap_bound, found.score);
}

}  // namespace
}  // namespace enfilade::room_detector
