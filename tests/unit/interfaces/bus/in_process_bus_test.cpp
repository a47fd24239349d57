// SPDX-License-Identifier: Apache-2.0
#include "interfaces/bus/in_process_bus.hpp"

#include <gtest/gtest.h>

#include "interfaces/runtime/virtual_time.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade {
namespace {

struct Participant {
  Participant(VirtualScheduler& scheduler, InProcessNetwork& network, const std::string& name, int index)
      : executor(scheduler, index), bus(network, name, index, [this](int writer, std::function<void()> work) {
          executor.post_from(writer, std::move(work));
        }) {}
  VirtualExecutor executor;
  InProcessBus bus;
};

struct InProcessBusTest : testing::Test {
  void run() { scheduler.run_until({}, scheduler.now_ns()); }

  VirtualScheduler scheduler;
  InProcessNetwork network;
  Participant motor{scheduler, network, "motorControl", 0};
  Participant topo{scheduler, network, "topoGraph", 1};
  Participant tool{scheduler, network, "enfilade", 2};
};

TransformList named(const std::string& name) {
  TransformList list;
  list.transforms.resize(1);
  list.transforms[0].child_frame_id = name;
  return list;
}

TEST_F(InProcessBusTest, HandlersRunAfterPublishReturnsInTheOrderOfPublishing) {
  std::vector<StampNs> seen;
  tool.bus.subscribe<Odometry>(topics::kOdom, [&](const Odometry& odom) { seen.push_back(odom.stamp_ns); });
  const auto odom = motor.bus.advertise(topics::kOdom);
  odom.publish({.stamp_ns = 1});
  odom.publish({.stamp_ns = 2});
  EXPECT_TRUE(seen.empty());
  run();
  EXPECT_EQ(seen, (std::vector<StampNs>{1, 2}));
}

TEST_F(InProcessBusTest, MessagesOfOneInstantArriveByTheWritersIndexNotByTheOrderOfPublishing) {
  std::vector<std::string> seen;
  tool.bus.subscribe<TransformList>(
      topics::kTf, [&](const TransformList& tf) { seen.push_back(tf.transforms[0].child_frame_id); });
  const auto from_topo = topo.bus.advertise(topics::kTf);
  const auto from_motor = motor.bus.advertise(topics::kTf);
  from_topo.publish(named("odom"));
  from_motor.publish(named("base_link"));
  run();
  EXPECT_EQ(seen, (std::vector<std::string>{"base_link", "odom"}));
}

TEST_F(InProcessBusTest, LateReaderOfALatchedTopicGetsTheLastDepthMessagesOnce) {
  static_assert(topics::kMotorState.info.qos.latched && topics::kMotorState.info.qos.depth == 1);
  const auto state = motor.bus.advertise(topics::kMotorState);
  state.publish({.stamp_ns = 1});
  state.publish({.stamp_ns = 2});
  std::vector<StampNs> seen;
  tool.bus.subscribe<MotorState>(topics::kMotorState,
                                 [&](const MotorState& s) { seen.push_back(s.stamp_ns); });
  EXPECT_TRUE(seen.empty());
  run();
  EXPECT_EQ(seen, std::vector<StampNs>{2});
}

TEST_F(InProcessBusTest, LateReaderOfAStreamGetsNothingOld) {
  motor.bus.advertise(topics::kOdom).publish({.stamp_ns = 1});
  bool called = false;
  tool.bus.subscribe<Odometry>(topics::kOdom, [&](const Odometry&) { called = true; });
  run();
  EXPECT_FALSE(called);
}

TEST_F(InProcessBusTest, WhatALatchedWriterKeptDiesWithIt) {
  motor.bus.advertise(topics::kMotorState).publish({.stamp_ns = 1});
  bool called = false;
  tool.bus.subscribe<MotorState>(topics::kMotorState, [&](const MotorState&) { called = true; });
  run();
  EXPECT_FALSE(called);
}

TEST_F(InProcessBusTest, AReaderThatIsGoneIsNotCalledForWhatWasUnderWay) {
  bool called = false;
  const auto odom = motor.bus.advertise(topics::kOdom);
  {
    Participant explorer(scheduler, network, "explorer", 3);
    explorer.bus.subscribe<Odometry>(topics::kOdom, [&](const Odometry&) { called = true; });
    EXPECT_EQ(odom.matched_readers(), 1);
    odom.publish({});
  }
  EXPECT_EQ(odom.matched_readers(), 0);
  run();
  EXPECT_FALSE(called);
}

TEST_F(InProcessBusTest, OpeningATopicThatTheTableDoesNotGiveNamesParticipantAndTopic) {
  try {
    topo.bus.advertise(topics::kOdom);
    FAIL() << "topoGraph wrote rt/odom";
  } catch (const std::logic_error& e) {
    EXPECT_NE(std::string(e.what()).find("topoGraph may not write rt/odom"), std::string::npos) << e.what();
  }
  EXPECT_THROW(topo.bus.subscribe<GroundTruth>(topics::kGroundTruth, [](const GroundTruth&) {}),
               std::logic_error);
  EXPECT_THROW(tool.bus.advertise(topics::kCmdVel), std::logic_error);
}

TEST(InProcessNetwork, EveryMessageGoesThroughTheWireHook) {
  VirtualScheduler scheduler;
  InProcessNetwork network([](const TopicInfo& topic, const AnyMessage& message) -> AnyMessage {
    if (topic.name != topics::kOdom.info.name) return message;
    auto changed = *std::static_pointer_cast<const Odometry>(message);
    changed.stamp_ns += 100;
    return std::make_shared<const Odometry>(changed);
  });
  Participant motor(scheduler, network, "motorControl", 0);
  StampNs seen = 0;
  motor.bus.advertise(topics::kOdom);
  Participant tool(scheduler, network, "enfilade", 1);
  tool.bus.subscribe<Odometry>(topics::kOdom, [&](const Odometry& odom) { seen = odom.stamp_ns; });
  motor.bus.advertise(topics::kOdom).publish({.stamp_ns = 1});
  scheduler.run_until({}, 0);
  EXPECT_EQ(seen, 101);
}

}  // namespace
}  // namespace enfilade
