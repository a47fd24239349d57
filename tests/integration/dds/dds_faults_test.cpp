// SPDX-License-Identifier: Apache-2.0
#include <atomic>

#include <gtest/gtest.h>

#include "interfaces/convert/wire_codec.hpp"
#include "interfaces/dds/participant.hpp"
#include "interfaces/topics/topics.hpp"
#include "tests/integration/dds/dds_fixture.hpp"

namespace enfilade {
namespace {

using test::eventually;
using test::own_config;
using test::Peer;

const PointCloud kCloud{7, "base_link", {{1, 2, 3}, {4, 5, 6}}};

/// A stranger who writes what it likes.
class Stranger {
 public:
  explicit Stranger(const TopicInfo& topic)
      : participant_("stranger", own_config(), [](const std::string&) {}),
        writer_(participant_.make_writer(topic, nullptr)) {}

  bool has_reader() const {
    eprosima::fastdds::dds::PublicationMatchedStatus status;
    writer_->get_publication_matched_status(status);
    return status.current_count > 0;
  }
  void write(wire::WireBytes bytes) { writer_->write(&bytes); }

 private:
  Participant participant_;
  eprosima::fastdds::dds::DataWriter* writer_;
};

TEST(DdsBus, DropsACorruptedCloudWithOneWarningAndTakesTheNext) {
  Peer reader("gridBuilder", own_config());
  std::atomic<int> clouds = 0;
  reader.bus->subscribe<PointCloud>(topics::kPoints,
                                    [&](const PointCloud& cloud) { clouds += cloud == kCloud ? 1 : 100; });
  Stranger stranger(topics::kPoints.info);
  ASSERT_TRUE(eventually([&] { return stranger.has_reader(); }));
  const wire::WireBytes good = wire::codec_of(topics::kPoints.info).encode(&kCloud);
  wire::WireBytes corrupted = good;
  const std::size_t width = 4 + 8 + 4 + 12 + 4;  // after encapsulation, stamp, frame_id and height
  ASSERT_EQ(corrupted[width], 2);
  corrupted[width] = 200;
  stranger.write(corrupted);
  stranger.write({0x00, 0x01, 0x00, 0x00, 0x01});
  stranger.write(good);
  EXPECT_TRUE(eventually([&] { return clouds == 1; }));
  EXPECT_EQ(reader.bus->drops().undecodable, 2U);
  EXPECT_TRUE(eventually([&] { return reader.log.count("rt/points") == 1; }));
  reader.bus.reset();
}

TEST(DdsBus, NamesTheTopicOfAWriterThatOffersLessThanAsked) {
  Peer reader("explorer", own_config());
  reader.bus->subscribe<CurrentZone>(topics::kCurrentZone, [](const CurrentZone&) {});
  TopicInfo weaker = topics::kCurrentZone.info;
  weaker.qos.latched = false;
  const Stranger stranger(weaker);
  EXPECT_TRUE(eventually([&] { return reader.log.count("rt/enfilade/current_zone") == 1; }));
  EXPECT_EQ(reader.log.count("durability"), 1);
}

TEST(DdsBus, NamesTheTopicThatSomebodyOpensWithAnotherType) {
  TopicInfo other = topics::kMotorState.info;
  other.wire_type = topics::kSweepCommand.info.wire_type;
  const Stranger before(other);
  Peer reader("explorer", own_config());
  reader.bus->subscribe<MotorState>(topics::kMotorState, [](const MotorState&) {});
  EXPECT_TRUE(eventually([&] { return reader.log.count("rt/enfilade/motor_state") == 1; }));
}

}  // namespace
}  // namespace enfilade
