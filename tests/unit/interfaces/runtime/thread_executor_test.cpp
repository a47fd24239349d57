// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/thread_executor.hpp"

#include <future>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "interfaces/runtime/deployed_clock.hpp"

namespace enfilade {
namespace {

using std::chrono::milliseconds;
constexpr StampNs kMs = 1'000'000;

/// Waits until the executor has done all that was posted so far.
void drain(ThreadExecutor& executor) {
  std::promise<void> done;
  executor.post([&done] { done.set_value(); });
  done.get_future().wait();
}

TEST(ThreadExecutor, RunsWhatManyThreadsPostEachInItsOwnOrder) {
  constexpr int kThreads = 4, kEach = 2000;
  ThreadExecutor executor;
  std::vector<int> next(kThreads, 0);  // touched by the executor's thread only
  bool in_order = true;
  executor.start();
  std::vector<std::thread> posters;
  for (int t = 0; t < kThreads; ++t) {
    posters.emplace_back([&, t] {
      for (int i = 0; i < kEach; ++i) executor.post([&, t, i] { in_order = in_order && next[t]++ == i; });
    });
  }
  for (std::thread& poster : posters) poster.join();
  drain(executor);
  EXPECT_TRUE(in_order);
  EXPECT_EQ(next, std::vector<int>(kThreads, kEach));
}

TEST(ThreadExecutor, DropsAndCountsWhatOthersPostToAFullQueue) {
  ThreadExecutor executor(nullptr, {.max_queued = 3});
  std::string ran;
  std::promise<void> third;
  executor.post([&] { ran += 'a'; });
  executor.post([&] { ran += 'b'; });
  executor.post([&] { third.set_value(); });
  executor.post([&] { ran += 'd'; });
  EXPECT_EQ(executor.dropped(), 1u);
  executor.start();
  third.get_future().wait();
  drain(executor);
  EXPECT_EQ(ran, "ab");
}

TEST(ThreadExecutor, NeverDropsWhatTheComponentPostsToItself) {
  ThreadExecutor executor(nullptr, {.max_queued = 1});
  int ran = 0;
  std::promise<void> done;
  executor.post([&] {
    for (int i = 0; i < 5; ++i) executor.post([&] { ++ran; });
    executor.post([&] { done.set_value(); });
  });
  executor.start();
  done.get_future().wait();
  EXPECT_EQ(ran, 5);
  EXPECT_EQ(executor.dropped(), 0u);
}

TEST(ThreadExecutor, TimersFollowTheTickingClockAndSkipMissedPeriods) {
  SimulatedClock clock;
  ThreadExecutor executor(&clock);
  std::vector<StampNs> calls;
  executor.every(10, [&] { calls.push_back(clock.now_ns()); });
  executor.start();
  for (const StampNs now_ns : {5, 10, 15, 19, 47, 48, 50}) {
    executor.post([&, now_ns] {
      clock.set(now_ns);
      executor.ticked();
    });
  }
  drain(executor);
  EXPECT_EQ(calls, (std::vector<StampNs>{10, 47, 50}));
}

TEST(ThreadExecutor, ATickingClockThatIsSetBackBeginsANewPeriod) {
  SimulatedClock clock;
  clock.set(1000);
  ThreadExecutor executor(&clock);
  std::vector<StampNs> calls;
  executor.every(10, [&] { calls.push_back(clock.now_ns()); });
  executor.start();
  for (const StampNs now_ns : {3, 12, 13}) {
    executor.post([&, now_ns] {
      clock.set(now_ns);
      executor.ticked();
    });
  }
  drain(executor);
  EXPECT_EQ(calls, std::vector<StampNs>{13});
}

TEST(ThreadExecutor, WallTimersRunWhileTheTickingClockStandsStill) {
  SimulatedClock clock;
  ThreadExecutor executor(&clock);
  std::promise<void> thrice;
  int calls = 0;
  executor.every_wall(5 * kMs, [&] {
    if (++calls == 3) thrice.set_value();
  });
  executor.start();
  EXPECT_EQ(thrice.get_future().wait_for(milliseconds(5000)), std::future_status::ready);
}

TEST(ThreadExecutor, WithoutATickingClockEveryFollowsWallTime) {
  ThreadExecutor executor;
  std::promise<void> twice;
  int calls = 0;
  const auto begin = std::chrono::steady_clock::now();
  executor.every(20 * kMs, [&] {
    if (++calls == 2) twice.set_value();
  });
  executor.start();
  ASSERT_EQ(twice.get_future().wait_for(milliseconds(5000)), std::future_status::ready);
  EXPECT_GE(std::chrono::steady_clock::now() - begin, milliseconds(40));
}

TEST(ThreadExecutor, HandsExceptionsToItsHandlerAndGoesOn) {
  ThreadExecutor executor;
  int caught = 0;
  executor.on_exception([&](const std::exception_ptr&) { ++caught; });
  executor.start();
  executor.post([] { throw std::runtime_error("once"); });
  executor.post([] { throw std::runtime_error("twice"); });
  drain(executor);
  EXPECT_EQ(caught, 2);
}

TEST(ThreadExecutor, StopRunsTheLastWorkAndNothingElse) {
  ThreadExecutor executor;
  std::string story;
  std::promise<void> started;
  std::promise<void> go_on;
  executor.start();
  executor.post([&] {
    started.set_value();
    go_on.get_future().wait();
    story += 'a';
  });
  executor.post([&] { story += 'b'; });
  started.get_future().wait();
  executor.stop([&] { story += 'z'; });
  EXPECT_FALSE(executor.wait_stopped(milliseconds(20)));
  go_on.set_value();
  EXPECT_TRUE(executor.wait_stopped(milliseconds(5000)));
  EXPECT_EQ(story, "az");
}

TEST(ThreadExecutor, TimersAreForTheComponentsOwnThread) {
  ThreadExecutor executor;
  executor.start();
  drain(executor);
  EXPECT_THROW(executor.every(kMs, [] {}), std::logic_error);
}

}  // namespace
}  // namespace enfilade
