// SPDX-License-Identifier: Apache-2.0
// A component as it is deployed, but for DDS: its own thread, wall time for the heartbeat, simulated time
// from rt/clock.
#include <chrono>
#include <mutex>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "interfaces/bus/in_process_bus.hpp"
#include "interfaces/runtime/component.hpp"
#include "interfaces/runtime/component_log.hpp"
#include "interfaces/runtime/simulated_time.hpp"
#include "interfaces/topics/topics.hpp"
#include "tests/support/fake_node.hpp"

namespace enfilade {
namespace {

struct ThreadedBus {
  ThreadedBus(InProcessNetwork& network, const std::string& name, int index, ThreadExecutor& executor)
      : bus(network, name, index,
            [&executor](int, std::function<void()> work) { executor.post(std::move(work)); }) {}
  InProcessBus bus;
};

/// What another thread has received.
template <class T>
class Received {
 public:
  Received(InProcessNetwork& network, const Topic<T>& topic)
      : bus_(network, "enfilade", 9, [](int, auto work) { work(); }) {
    bus_.subscribe<T>(topic, [this](const T& message) {
      const std::lock_guard lock(mutex_);
      messages_.push_back(message);
    });
  }
  std::vector<T> messages() {
    const std::lock_guard lock(mutex_);
    return messages_;
  }
  bool wait_for(const std::function<bool(const std::vector<T>&)>& condition) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (std::chrono::steady_clock::now() < deadline) {
      if (condition(messages())) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
  }

 private:
  std::mutex mutex_;
  std::vector<T> messages_;
  InProcessBus bus_;
};

struct DeployedComponentTest : testing::Test {
  void TearDown() override {
    executor.stop([this] { component->stop(); });
    ASSERT_TRUE(executor.wait_stopped(std::chrono::seconds(5)));
  }

  void make(FakeNode::Calls calls, double heartbeat_s = 0.005) {
    component = std::make_unique<Component>(
        ComponentConfig{
            .name = "explorer", .period = {.compute_s = 0.05}, .heartbeat_s = heartbeat_s, .pid = 7},
        explorer.bus, clock, executor, log, FakeNode::make(std::move(calls)));
    time = std::make_unique<SimulatedTime>(SimulatedTimeConfig{.component = "explorer"}, explorer.bus, clock,
                                           executor, [this] { component->start(); });
    component->announce();
    executor.start();
  }
  void tick(double t_s) { ticks.publish({.now_ns = from_seconds(t_s)}); }

  InProcessNetwork network;
  SimulatedClock clock;
  ThreadExecutor executor{&clock};
  ThreadedBus explorer{network, "explorer", 1, executor};
  InProcessBus simulator{network, "simulator", 0, [](int, auto work) { work(); }};
  Publisher<ClockTick> ticks = simulator.advertise(topics::kClock);
  ComponentLog log{"explorer", clock, {}};
  std::unique_ptr<Component> component;
  std::unique_ptr<SimulatedTime> time;
};

TEST_F(DeployedComponentTest, IsSeenBeforeTheFirstTickAndInitializesWithIt) {
  Received<Heartbeat> beats(network, topics::kHeartbeat);
  std::atomic<StampNs> initialized_ns = -1;
  make({.initialize = [&](const NodeContext& c) { initialized_ns = c.clock.now_ns(); }});
  EXPECT_TRUE(beats.wait_for([](const auto& b) { return b.size() >= 2; }));
  EXPECT_EQ(beats.messages()[0].state, LifecycleState::kInitializing);
  EXPECT_EQ(beats.messages()[0].pid, 7u);
  EXPECT_EQ(initialized_ns, -1);
  tick(3.0);
  EXPECT_TRUE(beats.wait_for([](const auto& b) { return b.back().state == LifecycleState::kComputing; }));
  EXPECT_EQ(initialized_ns, from_seconds(3.0));
}

TEST_F(DeployedComponentTest, ComputesInSimulatedTime) {
  Received<Heartbeat> beats(network, topics::kHeartbeat);
  make({});
  for (int i = 0; i <= 100; ++i) tick(0.005 * i);
  EXPECT_TRUE(beats.wait_for([](const auto& b) { return !b.empty() && b.back().cycles == 10; }));
}

TEST_F(DeployedComponentTest, AHungComputeStopsTheHeartbeat) {
  Received<Heartbeat> beats(network, topics::kHeartbeat);
  std::atomic<bool> hung = false, let_go = false;
  make({.compute = [&](const NodeContext&) {
    hung = true;
    while (!let_go) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }});
  tick(0.0);
  tick(0.05);
  while (!hung) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const std::size_t before = beats.messages().size();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(beats.messages().size(), before);
  let_go = true;
  EXPECT_TRUE(beats.wait_for([before](const auto& b) { return b.size() > before; }));
}

TEST_F(DeployedComponentTest, GivesCreditForWhatIsHandledAtMostOncePer20Ms) {
  Received<SimCredit> credits(network, topics::kSimCredit);
  make({}, 10.0);
  for (int i = 0; i <= 200; ++i) {
    tick(0.005 * i);
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  }
  ASSERT_TRUE(
      credits.wait_for([](const auto& c) { return !c.empty() && c.back().done_ns > from_seconds(0.98); }));
  const auto all = credits.messages();
  EXPECT_EQ(all.front().component_name, "explorer");
  for (std::size_t i = 1; i < all.size(); ++i)
    EXPECT_GE(all[i].done_ns - all[i - 1].done_ns, from_seconds(0.02));
}

TEST_F(DeployedComponentTest, TheHeartbeatSaysWhyThereIsAnEmergency) {
  Received<Heartbeat> beats(network, topics::kHeartbeat);
  make({.compute = [](const NodeContext&) { throw std::runtime_error("no wheels"); }});
  tick(0.0);
  tick(0.05);
  ASSERT_TRUE(beats.wait_for(
      [](const auto& b) { return !b.empty() && b.back().state == LifecycleState::kEmergency; }));
  EXPECT_EQ(beats.messages().back().detail, "compute() failed: no wheels");
}

}  // namespace
}  // namespace enfilade
