// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/virtual_time.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace enfilade {
namespace {

TEST(VirtualScheduler, RunsByTimeThenParticipantThenSequence) {
  VirtualScheduler scheduler;
  std::string order;
  scheduler.at(20, 0, [&] { order += 'e'; });
  scheduler.at(10, 1, [&] { order += 'c'; });
  scheduler.at(10, 1, [&] { order += 'd'; });
  scheduler.at(10, 0, [&] { order += 'b'; });
  scheduler.at(5, 9, [&] { order += 'a'; });
  EXPECT_FALSE(scheduler.run_until({}, 100));
  EXPECT_EQ(order, "abcde");
  EXPECT_EQ(scheduler.now_ns(), 100);
}

TEST(VirtualScheduler, LeavesWhatIsLaterThanTheDeadlineAndStopsWhenAsked) {
  VirtualScheduler scheduler;
  int ran = 0;
  for (StampNs t = 1; t <= 10; ++t) scheduler.at(t, 0, [&] { ++ran; });
  EXPECT_FALSE(scheduler.run_until({}, 4));
  EXPECT_EQ(ran, 4);
  EXPECT_TRUE(scheduler.run_until([&] { return ran == 7; }, 100));
  EXPECT_EQ(scheduler.now_ns(), 7);
}

TEST(VirtualScheduler, WhatIsGivenForThePastRunsNow) {
  VirtualScheduler scheduler;
  scheduler.run_until({}, 50);
  StampNs ran_ns = 0;
  scheduler.at(10, 0, [&] { ran_ns = scheduler.now_ns(); });
  scheduler.run_until({}, 60);
  EXPECT_EQ(ran_ns, 50);
}

TEST(VirtualExecutor, PeriodicWorkRunsFirstAfterOnePeriod) {
  VirtualScheduler scheduler;
  VirtualExecutor executor(scheduler, 0);
  std::vector<StampNs> at;
  executor.every(30, [&] { at.push_back(scheduler.now_ns()); });
  executor.every_wall(1, [&] { at.push_back(-1); });
  scheduler.run_until({}, 100);
  EXPECT_EQ(at, (std::vector<StampNs>{30, 60, 90}));
}

TEST(VirtualExecutor, TakesItsEventsWithIt) {
  VirtualScheduler scheduler;
  int ran = 0;
  {
    VirtualExecutor executor(scheduler, 0);
    executor.every(10, [&] { ++ran; });
    executor.post([&] { ++ran; });
  }
  scheduler.run_until({}, 100);
  EXPECT_EQ(ran, 0);
}

TEST(VirtualExecutor, HandsExceptionsToItsHandlerAndGoesOn) {
  VirtualScheduler scheduler;
  VirtualExecutor executor(scheduler, 0);
  int caught = 0;
  executor.on_exception([&](const std::exception_ptr&) { ++caught; });
  executor.every(10, [] { throw std::runtime_error("again"); });
  scheduler.run_until({}, 35);
  EXPECT_EQ(caught, 3);
}

TEST(VirtualExecutor, WithoutAHandlerExceptionsReachTheCaller) {
  VirtualScheduler scheduler;
  VirtualExecutor executor(scheduler, 0);
  executor.post([] { throw std::runtime_error("out"); });
  EXPECT_THROW(scheduler.run_until({}, 1), std::runtime_error);
}

}  // namespace
}  // namespace enfilade
