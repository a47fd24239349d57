// SPDX-License-Identifier: Apache-2.0
#include "interfaces/dds/dds_bus.hpp"

#include <atomic>
#include <map>

#include <gtest/gtest.h>

#include "tests/integration/dds/dds_fixture.hpp"
#include "tests/support/random_messages.hpp"

namespace enfilade {
namespace {

using test::eventually;
using test::own_config;
using test::Peer;

std::string first_writer(const TopicInfo& topic) {
  const std::string first(topic.writers.substr(0, topic.writers.find(' ')));
  return first == "*" ? "explorer" : first;
}

TEST(DdsBus, CarriesEveryTopic) {
  std::map<std::string, std::unique_ptr<Peer>> writers;
  Peer reader("enfilade_test", own_config());
  test::RandomMessages random(1);
  topics::for_each_topic([&]<class T>(const Topic<T>& topic) {
    auto& writer = writers[first_writer(topic.info)];
    if (!writer) writer = std::make_unique<Peer>(first_writer(topic.info), own_config());
    const auto publisher = writer->bus->advertise(topic);
    const T sent = random.make<T>();
    std::atomic<bool> arrived = false, equal = false;
    reader.bus->subscribe<T>(topic, [&](const T& message) {
      equal = test::same(message, sent);
      arrived = true;
    });
    ASSERT_TRUE(eventually([&] { return publisher.matched_readers() == 1; })) << topic.info.name;
    publisher.publish(sent);
    EXPECT_TRUE(eventually([&] { return arrived.load(); })) << topic.info.name;
    EXPECT_TRUE(equal) << topic.info.name;
  });
  reader.bus.reset();  // before the variables its handlers refer to would be used again
}

TEST(DdsBus, GivesALateReaderTheLatchedState) {
  Peer writer("topoGraph", own_config());
  const auto publisher = writer.bus->advertise(topics::kCurrentZone);
  publisher.publish({.zone_id = 6});
  publisher.publish({.zone_id = 7});
  std::atomic<unsigned> zone = 0;
  Peer reader("explorer", own_config());
  reader.bus->subscribe<CurrentZone>(topics::kCurrentZone,
                                     [&](const CurrentZone& message) { zone = message.zone_id; });
  EXPECT_TRUE(eventually([&] { return zone == 7; }));
  reader.bus.reset();
}

TEST(DdsBus, OpensOnlyWhatTheTopicTableGives) {
  Peer peer("roomDetector", own_config());
  EXPECT_THROW(peer.bus->advertise(topics::kScan), std::logic_error);
  EXPECT_THROW(peer.bus->subscribe<GroundTruth>(topics::kGroundTruth, [](const GroundTruth&) {}),
               std::logic_error);
  EXPECT_NO_THROW(peer.bus->advertise(topics::kRoomEstimate));
}

TEST(DdsBus, RunsHandlersOnTheExecutorOnlyAndNoneAfterItsEnd) {
  Peer writer("explorer", own_config());
  const auto publisher = writer.bus->advertise(topics::kCmdVel);
  Peer reader("motorControl", own_config());
  std::atomic<int> handled = 0;
  std::atomic<bool> elsewhere = false;
  std::thread::id own_thread;
  reader.executor.post([&] { own_thread = std::this_thread::get_id(); });
  reader.bus->subscribe<VelocityCommand>(topics::kCmdVel, [&](const VelocityCommand&) {
    if (std::this_thread::get_id() != own_thread) elsewhere = true;
    ++handled;
  });
  ASSERT_TRUE(eventually([&] { return publisher.matched_readers() == 1; }));
  ASSERT_TRUE(eventually([&] {
    publisher.publish({});
    return handled > 5;
  }));
  for (int i = 0; i < 16; ++i) publisher.publish({});
  reader.bus.reset();
  const int at_end = handled;
  std::atomic<bool> later = false;
  reader.executor.post([&] { later = true; });
  ASSERT_TRUE(eventually([&] { return later.load(); }));
  EXPECT_EQ(handled, at_end);
  EXPECT_FALSE(elsewhere);
}

TEST(DdsBus, OutlivesItsPublishersAndTheyMayOutliveIt) {
  Peer writer("explorer", own_config());
  const auto publisher = writer.bus->advertise(topics::kCmdVel);
  { const auto other = writer.bus->advertise(topics::kCmdVel); }
  writer.bus.reset();
  publisher.publish({});
  EXPECT_EQ(publisher.matched_readers(), 0);
}

}  // namespace
}  // namespace enfilade
