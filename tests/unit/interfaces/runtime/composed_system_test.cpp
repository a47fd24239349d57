// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/composed_system.hpp"

#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/fake_node.hpp"
#include "tests/support/node_harness.hpp"

namespace enfilade {
namespace {

/// A ring of two: odometry goes out every 20 ms and each one is answered by a velocity.
std::string run_ring() {
  std::ostringstream record;
  ComposedSystem system;
  system.tool_bus().subscribe<VelocityCommand>(topics::kCmdVel, [&](const VelocityCommand& command) {
    record << system.clock().now_ns() << " v " << command.linear_m_s << '\n';
  });
  auto odom = std::make_shared<Publisher<Odometry>>();
  system.add(
      "motorControl", {.compute_s = 0.02},
      FakeNode::make(
          {.initialize =
               [odom](const NodeContext& c) {
                 *odom = c.bus.advertise(topics::kOdom);
                 c.bus.subscribe<VelocityCommand>(topics::kCmdVel, [](const VelocityCommand&) {});
               },
           .compute = [odom](const NodeContext& c) { odom->publish({.stamp_ns = c.clock.now_ns()}); }}));
  auto velocity = std::make_shared<Publisher<VelocityCommand>>();
  system.add("explorer", {.compute_s = 0.05},
             FakeNode::make(
                 {.initialize =
                      [velocity](const NodeContext& c) {
                        *velocity = c.bus.advertise(topics::kCmdVel);
                        c.bus.subscribe<Odometry>(topics::kOdom, [velocity](const Odometry& o) {
                          velocity->publish({.linear_m_s = seconds(o.stamp_ns)});
                        });
                      },
                  .compute = [velocity](const NodeContext&) { velocity->publish({.linear_m_s = -1.0}); }}));
  system.run_until({}, from_seconds(1.0));
  return record.str();
}

TEST(ComposedSystem, TheSameCallsGiveTheSameRunByteForByte) {
  const std::string once = run_ring();
  EXPECT_EQ(once, run_ring());
  EXPECT_EQ(std::ranges::count(once, '\n'), 50 + 20);
}

TEST(ComposedSystem, InitializesInTheOrderOfAddingAndShutsDownAtTheEnd) {
  std::string story;
  {
    ComposedSystem system;
    for (const char* name : {"motorControl", "gridBuilder"}) {
      system.add(name, {},
                 FakeNode::make({.initialize = [&](const NodeContext& c) { story += c.component[0]; },
                                 .shutdown = [&](const NodeContext& c) { story += c.component[0] - 32; }}));
    }
    EXPECT_FALSE(system.run_until({}, 0));
    EXPECT_THROW(system.add("gridBuilder", {}, FakeNode::make({})), std::logic_error);
  }
  EXPECT_EQ(story, "mgMG");
}

TEST(ComposedSystem, AKilledComponentIsSilentAndMayComeBack) {
  ComposedSystem system;
  std::string story;
  const auto add = [&](char letter) {
    system.add("explorer", {.compute_s = 0.1},
               FakeNode::make({.compute = [&story, letter](const NodeContext&) { story += letter; },
                               .shutdown = [&story](const NodeContext&) { story += 's'; }}));
  };
  add('a');
  system.run_until({}, from_seconds(0.25));
  system.kill("explorer");
  system.run_until({}, from_seconds(0.5));
  add('b');
  system.run_until({}, from_seconds(0.75));
  EXPECT_EQ(story, "aabb");
  EXPECT_THROW(system.kill("topoGraph"), std::out_of_range);
}

TEST(ComposedSystem, StopsAsSoonAsTheConditionHolds) {
  ComposedSystem system;
  int cycles = 0;
  system.add("explorer", {.compute_s = 0.1},
             FakeNode::make({.compute = [&](const NodeContext&) { ++cycles; }}));
  EXPECT_TRUE(system.run_until([&] { return cycles == 3; }, from_seconds(10.0)));
  EXPECT_EQ(system.clock().now_ns(), from_seconds(0.3));
}

struct EchoConfig {
  PeriodConfig period;
  double gain = 2.0;
};

struct EchoNode : Node {
  EchoNode(const NodeContext& c, const EchoConfig& config_in) : context(c), config(config_in) {}
  void initialize() override {
    velocity = context.bus.advertise(topics::kCmdVel);
    context.bus.subscribe<Odometry>(topics::kOdom, [this](const Odometry& o) {
      if (o.stamp_ns < 0) throw std::runtime_error("time runs backwards");
      velocity.publish({.linear_m_s = config.gain * seconds(o.stamp_ns)});
    });
  }
  void compute() override {}
  NodeContext context;
  EchoConfig config;
  Publisher<VelocityCommand> velocity;
};

TEST(NodeHarness, PlaysTheOtherComponentsAndCollectsWhatTheNodeSays) {
  NodeHarness<EchoNode, EchoConfig> harness("explorer", {.period = {}, .gain = 3.0});
  auto& commands = harness.collect(topics::kCmdVel);
  harness.advance_s(0.0);
  harness.publish(topics::kOdom, {.stamp_ns = from_seconds(2.0)});
  harness.advance_s(0.0);
  ASSERT_EQ(commands.size(), 1u);
  EXPECT_DOUBLE_EQ(commands[0].linear_m_s, 6.0);
}

TEST(NodeHarness, AnExceptionInTheNodeFailsTheTest) {
  NodeHarness<EchoNode, EchoConfig> harness("explorer", {});
  harness.node();
  harness.publish(topics::kOdom, {.stamp_ns = -1});
  EXPECT_THROW(harness.advance_s(0.1), std::runtime_error);
}

}  // namespace
}  // namespace enfilade
