// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/crew.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace enfilade {
namespace {

/// Long enough for all workers to take part, short enough for them to meet at the next task.
void work_a_little() {
  for (volatile int i = 0; i < 30;) i = i + 1;
}

TEST(Crew, DoesEachTaskOfEachListOnce) {
  Crew crew(4);
  for (int list = 0; list < 3000; ++list) {
    const int tasks = list % 50;
    std::vector<std::atomic<int>> done(static_cast<std::size_t>(tasks));
    crew.run(tasks, [&](int task, int) {
      work_a_little();
      ++done[static_cast<std::size_t>(task)];
    });
    for (const auto& times : done) ASSERT_EQ(times, 1) << "list " << list;
  }
}

TEST(Crew, NeverHasTwoTasksAtWorkWithTheSameWorker) {
  Crew crew(4);
  std::vector<std::atomic<bool>> at_work(static_cast<std::size_t>(crew.size()));
  std::atomic<int> clashes = 0;
  for (int list = 0; list < 300; ++list) {
    crew.run(40, [&](int, int worker) {
      auto& mine = at_work[static_cast<std::size_t>(worker)];
      clashes += mine.exchange(true);
      work_a_little();
      mine = false;
    });
  }
  EXPECT_EQ(clashes, 0);
}

TEST(Crew, WorksWithItsThreadsBesideEachOther) {
  Crew crew(2);
  if (crew.size() < 2) GTEST_SKIP() << "only one processor";
  std::atomic<int> begun = 0;
  std::array<int, 2> workers{-1, -1};
  crew.run(2, [&](int task, int worker) {
    workers[static_cast<std::size_t>(task)] = worker;
    ++begun;
    while (begun < 2) std::this_thread::yield();  // neither ends before the other has begun
  });
  EXPECT_EQ(workers[0] + workers[1], 1);
}

TEST(Crew, HasNoMoreWorkersThanThereAreProcessors) {
  EXPECT_LE(Crew(64).size(), static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  EXPECT_EQ(Crew(1).size(), 1);
}

TEST(Crew, EndsWhileItSleepsOrHasJustWorked) {
  for (int i = 0; i < 200; ++i) {
    Crew crew(3);
    if (i % 2) crew.run(5, [](int, int) {});
  }
}

}  // namespace
}  // namespace enfilade
