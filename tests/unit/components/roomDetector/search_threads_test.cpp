// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "components/roomDetector/core/rectangle_search.hpp"
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
HoughSpace random_space(test::RandomWorld& world) {
  HoughSpace space({.theta_step_deg = 1.0, .step_m = 0.125, .range_m = 4.0}, Point2(0.1, -0.2), 0.05);
  space.set_penalties({world.uniform(0.2, 2.0), world.integer(0, 3), world.integer(0, 2), 1});
  const auto votes = world.votes(4.5, 0.1);
  for (std::size_t i = 0; i < votes.size(); ++i) space.set(i, votes[i]);
  return space;
}

TEST(SearchThreads, FindTheSameByTheSameWorkHoweverManyTheyAre) {
  const SearchConfig config{
      .side_min_m = 0.9, .side_max_m = 5.0, .least_score = -1'000'000, .max_expansions = 1'000'000};
  int most = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    test::RandomWorld world(seed);
    const Point2 robot(world.uniform(-1.5, 1.5), world.uniform(-1.5, 1.5));
    const HoughSpace space = random_space(world);
    const auto alone = RectangleSearch(config).find_best(space, robot),
               beside = RectangleSearch(config, {}, threads()).find_best(space, robot);
    ASSERT_TRUE(alone && beside) << "seed " << seed;
    EXPECT_EQ(beside->rectangle, alone->rectangle) << "seed " << seed;
    EXPECT_EQ(beside->score, alone->score) << "seed " << seed;
    EXPECT_EQ(beside->gap, 0) << "seed " << seed;
    EXPECT_EQ(beside->expansions, alone->expansions) << "seed " << seed;
    EXPECT_EQ(beside->planes_opened, alone->planes_opened) << "seed " << seed;
    most = std::max(most, alone->expansions);
  }
  EXPECT_GT(most, 1000) << "no search took long enough for threads";
}

TEST(SearchThreads, KeepToTheBudget) {
  test::RandomWorld world(1);
  const HoughSpace space = random_space(world);
  const SearchConfig config{
      .side_min_m = 0.9, .side_max_m = 5.0, .least_score = -1'000'000, .max_expansions = 500};
  const auto alone = RectangleSearch(config).find_best(space, Point2(0.2, 0.1)),
             beside = RectangleSearch(config, {}, threads()).find_best(space, Point2(0.2, 0.1));
  ASSERT_TRUE(alone && beside);
  EXPECT_GT(beside->gap, 0);
  EXPECT_EQ(beside->gap, alone->gap);
  EXPECT_EQ(beside->expansions, alone->expansions);
}

}  // namespace
}  // namespace enfilade::room_detector
