// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/component.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "interfaces/runtime/composed_system.hpp"
#include "interfaces/topics/topics.hpp"
#include "tests/support/fake_node.hpp"

namespace enfilade {
namespace {

/// Writes one letter for each call of the life cycle.
struct ComponentTest : testing::Test {
  FakeNode::Call letter(char c) {
    return [this, c](const NodeContext&) { story += c; };
  }
  void add(FakeNode::Calls calls) {
    system.add("explorer", {.compute_s = 0.1, .emergency_s = 0.5}, FakeNode::make(std::move(calls)));
  }
  void run_to(double t_s) { system.run_until({}, from_seconds(t_s)); }

  std::string story;
  std::vector<std::string> lines;
  ComposedSystem system{
      {.log = [this](const LogLine& line) { lines.push_back(line.text); }, .through_wire = {}}};
};

TEST_F(ComponentTest, InitializesOnceAndThenComputesEveryPeriod) {
  add({.initialize = letter('i'), .compute = letter('c'), .emergency = letter('e')});
  run_to(0.35);
  EXPECT_EQ(story, "iccc");
  EXPECT_EQ(system.component("explorer").cycles(), 3u);
  EXPECT_EQ(system.component("explorer").state(), LifecycleState::kComputing);
}

TEST_F(ComponentTest, EmergencyReplacesComputeUntilRestoreHasRunOnce) {
  add({.compute =
           [&](const NodeContext& context) {
             story += 'c';
             if (seconds(context.clock.now_ns()) < 0.15) context.lifecycle.go_to_emergency("no laser");
           },
       .emergency =
           [&](const NodeContext& context) {
             story += 'e';
             EXPECT_TRUE(context.lifecycle.in_emergency());
             if (seconds(context.clock.now_ns()) > 0.9) context.lifecycle.go_to_restore();
           },
       .restore = letter('r')});
  run_to(1.25);  // emergency() at 0.5 s and 1.0 s, compute() at 0.1 s and from 1.1 s
  EXPECT_EQ(story, "ceercc");
  EXPECT_EQ(lines, (std::vector<std::string>{"emergency: no laser", "emergency is over"}));
}

TEST_F(ComponentTest, ExceptionFromComputeIsOneLineAndEmergency) {
  add({.compute =
           [&](const NodeContext&) {
             story += 'c';
             throw std::runtime_error("the grid is empty");
           },
       .emergency = letter('e')});
  run_to(1.2);
  EXPECT_EQ(story, "cee");
  EXPECT_EQ(lines, std::vector<std::string>{"compute() failed: the grid is empty"});
  EXPECT_EQ(system.component("explorer").failures(), 1);
}

TEST_F(ComponentTest, AnExceptionIsGotOverAfterARest) {
  add({.compute =
           [&](const NodeContext& context) {
             story += 'c';
             if (seconds(context.clock.now_ns()) < 0.15) throw std::runtime_error("one bad message");
           },
       .emergency = letter('e'),
       .restore = letter('r')});
  run_to(1.75);  // fails at 0.1 s; emergency() at 0.5, 1.0 and 1.5 s, the first that is a second later
  EXPECT_EQ(story, "ceeercc");
  EXPECT_EQ(system.component("explorer").state(), LifecycleState::kComputing);
}

TEST_F(ComponentTest, ExceptionFromAHandlerIsEmergencyToo) {
  add({.initialize = [](const NodeContext& context) {
    context.bus.subscribe<Odometry>(topics::kOdom,
                                    [](const Odometry&) { throw std::runtime_error("bad odometry"); });
  }});
  system.initialize();
  system.bus_as("motorControl").advertise(topics::kOdom).publish({});
  run_to(0.01);
  EXPECT_TRUE(system.component("explorer").in_emergency());
  EXPECT_EQ(lines, std::vector<std::string>{"a handler failed: bad odometry"});
}

TEST_F(ComponentTest, EmergencyAskedForInInitializeHolds) {
  add({.initialize = [](const NodeContext& context) { context.lifecycle.go_to_emergency("no map yet"); },
       .compute = letter('c'),
       .emergency = letter('e')});
  run_to(0.6);
  EXPECT_EQ(story, "e");
}

TEST_F(ComponentTest, ExceptionFromRestoreFallsBackToEmergency) {
  add({.initialize = [](const NodeContext& context) { context.lifecycle.go_to_emergency("start"); },
       .compute = letter('c'),
       .emergency = [](const NodeContext& context) { context.lifecycle.go_to_restore(); },
       .restore =
           [&](const NodeContext&) {
             story += 'r';
             if (story.size() < 2) throw std::runtime_error("not yet");
           }});
  run_to(1.15);
  EXPECT_EQ(story, "rrc");
}

TEST_F(ComponentTest, ExceptionFromInitializeReachesTheCaller) {
  add({.initialize = [](const NodeContext&) { throw std::runtime_error("no such file"); }});
  EXPECT_THROW(system.initialize(), std::runtime_error);
}

TEST_F(ComponentTest, LinesFromInfoUpTravelOnRosout) {
  std::vector<LogLine> rosout;
  system.tool_bus().subscribe<LogLine>(topics::kRosout, [&](const LogLine& line) { rosout.push_back(line); });
  add({.compute = [](const NodeContext& context) {
    context.log.debug("details");
    context.log.info("room 1 fixed");
  }});
  run_to(0.1);
  ASSERT_EQ(rosout.size(), 1u);
  EXPECT_EQ(rosout[0], (LogLine{from_seconds(0.1), 20, "explorer", "room 1 fixed"}));
  EXPECT_EQ(lines.size(), 2u);
}

}  // namespace
}  // namespace enfilade
