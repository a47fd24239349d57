// SPDX-License-Identifier: Apache-2.0
#include "interfaces/topics/topics.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace enfilade {
namespace {

const std::vector<std::string> kComponents{"laser3D",      "motorControl", "gridBuilder",
                                           "roomDetector", "explorer",     "topoGraph"};

TEST(Topics, NoComponentMayReadTheGroundTruth) {
  for (const std::string& component : kComponents) {
    EXPECT_FALSE(may_read(topics::kGroundTruth.info, component)) << component;
    EXPECT_FALSE(may_write(topics::kGroundTruth.info, component)) << component;
  }
  EXPECT_TRUE(may_read(topics::kGroundTruth.info, "enfilade"));
  EXPECT_TRUE(may_write(topics::kGroundTruth.info, "simulator"));
}

TEST(Topics, NamesAreUniqueAndEachHasAWriterThatExists) {
  std::set<std::string_view> names;
  for (const TopicInfo& topic : topics::table()) {
    EXPECT_TRUE(names.insert(topic.name).second) << topic.name;
    bool written = may_write(topic, "simulator") || may_write(topic, "enfilade");
    for (const std::string& component : kComponents) written |= may_write(topic, component);
    EXPECT_TRUE(written) << topic.name;
    EXPECT_GT(topic.qos.depth, 0) << topic.name;
  }
}

TEST(Topics, NamesAndTypesFollowTheRosWireRules) {
  for (const TopicInfo& topic : topics::table()) {
    const std::string prefix(topic.name.substr(0, 3));
    EXPECT_TRUE(prefix == "rt/" || prefix == "rq/" || prefix == "rr/") << topic.name;
    EXPECT_NE(topic.wire_type.find("::dds_::"), std::string_view::npos) << topic.name;
    EXPECT_TRUE(topic.wire_type.ends_with('_')) << topic.name;
  }
}

TEST(Topics, ToolsReadEverythingAndWriteNothingButRequestsThatNameThem) {
  for (const TopicInfo& topic : topics::table()) {
    EXPECT_TRUE(may_read(topic, "enfilade-viewer")) << topic.name;
    const bool asks =
        topic.name == topics::kRoute.request.info.name || topic.name == topics::kMarkDoor.request.info.name;
    EXPECT_EQ(may_write(topic, "enfilade-viewer"), asks) << topic.name;
    EXPECT_EQ(may_write(topic, "enfilade"), asks) << topic.name;
  }
}

TEST(Topics, ListsMatchesWholeNamesOnly) {
  EXPECT_TRUE(lists("gridBuilder explorer", "explorer"));
  EXPECT_FALSE(lists("gridBuilder explorer", "grid"));
  EXPECT_FALSE(lists("", "explorer"));
  EXPECT_TRUE(lists("*", "explorer"));
  EXPECT_FALSE(lists("*", "simulator"));
  EXPECT_FALSE(lists("*", "enfilade"));
}

}  // namespace
}  // namespace enfilade
