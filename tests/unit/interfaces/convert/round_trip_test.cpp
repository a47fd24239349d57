// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <memory>

#include <cxxabi.h>
#include <gtest/gtest.h>

#include "interfaces/convert/wire_codec.hpp"
#include "tests/support/random_messages.hpp"

namespace enfilade {
namespace {

TEST(WireCodec, BringsEveryMessageBackBitForBit) {
  test::RandomMessages random(1);
  topics::for_each_topic([&random]<class T>(const Topic<T>& topic) {
    for (int i = 0; i < 50; ++i) {
      const auto message = std::make_shared<const T>(random.make<T>());
      const AnyMessage back = wire::through_wire(topic.info, message);
      ASSERT_NE(back, message);
      ASSERT_TRUE(test::same(*message, *static_cast<const T*>(back.get()))) << topic.info.name;
    }
  });
}

TEST(WireCodec, NamesTheTypeThatTheTopicTableNames) {
  for (const TopicInfo& topic : topics::table()) {
    const wire::WireCodec& codec = wire::codec_of(topic);
    const std::unique_ptr<char, decltype(&std::free)> name(
        abi::__cxa_demangle(codec.idl_type.name(), nullptr, nullptr, nullptr), &std::free);
    EXPECT_EQ(topic.wire_type, name.get());
  }
}

TEST(WireCodec, GivesTheSameBytesForTheSameMessage) {
  const LaserScan scan = test::RandomMessages(2).make<LaserScan>();
  const wire::WireCodec& codec = wire::codec_of(topics::kScan.info);
  EXPECT_EQ(codec.encode(&scan), codec.encode(&scan));
}

/// Any message cut short anywhere, or with any byte changed, is either refused or read as some message:
/// nothing else happens.
TEST(WireCodec, RefusesOrReadsWhateverBytesCome) {
  test::RandomMessages random(3);
  std::mt19937_64 bits(4);
  topics::for_each_topic([&]<class T>(const Topic<T>& topic) {
    const wire::WireCodec& codec = wire::codec_of(topic.info);
    const T message = random.make<T>();
    const wire::WireBytes bytes = codec.encode(&message);
    for (int i = 0; i < 300; ++i) {
      wire::WireBytes broken = bytes;
      if (i % 3 == 0) broken.resize(bits() % bytes.size());
      if (!broken.empty()) broken[bits() % broken.size()] = static_cast<std::uint8_t>(bits());
      try {
        EXPECT_NE(codec.decode(broken), nullptr);
      } catch (const wire::WireError&) {
      }
    }
  });
}

TEST(WireCodec, RefusesEveryScanThatEndsTooEarly) {
  const LaserScan scan = test::RandomMessages(5).make<LaserScan>();
  const wire::WireCodec& codec = wire::codec_of(topics::kScan.info);
  const wire::WireBytes bytes = codec.encode(&scan);
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_THROW(codec.decode(std::span(bytes).first(length)), wire::WireError) << length;
  }
}

TEST(WireCodec, DoesNotKnowTypesOutsideTheTable) {
  EXPECT_THROW(wire::codec_of({.name = "rt/x", .wire_type = "x::X_"}), std::logic_error);
}

}  // namespace
}  // namespace enfilade
