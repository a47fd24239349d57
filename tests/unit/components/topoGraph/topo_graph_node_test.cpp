// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/node/topo_graph_node.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "components/topoGraph/storage/map_file.hpp"
#include "components/topoGraph/storage/map_folder.hpp"
#include "tests/support/node_harness.hpp"
#include "tests/unit/components/topoGraph/rooms.hpp"

namespace enfilade::topo_graph {
namespace {

namespace fs = std::filesystem;
using namespace test;
using Harness = NodeHarness<TopoGraphNode, TopoGraphConfig>;

const Pose2 kDrift{0.02, 0.06, 0.01};

class TopoGraphNodeTest : public testing::Test {
 protected:
  TopoGraphNodeTest() : folder_(fs::temp_directory_path() / ("topo_node_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    config_.map_file = folder_ / "map.yaml";
    config_.resume = true;
  }
  ~TopoGraphNodeTest() override { fs::remove_all(folder_); }

  static FixRoomRequest fix1() { return {call(1), estimate_of(room1(), 1, {door_from_room1()})}; }
  static EnterZoneRequest enter2() { return {call(2), 1, 1, {2.25, 0.55, 0.0}, from_seconds(0.5)}; }
  static FixRoomRequest fix2() {
    return {call(3), seen_from(kDrift, estimate_of(room2(), 2, {door_from_room2()}))};
  }

  fs::path folder_;
  TopoGraphConfig config_;
};

TEST_F(TopoGraphNodeTest, StartsZone1AndKeepsPublishingTheTransform) {
  Harness harness("topoGraph", config_);
  auto& zones = harness.collect(topics::kCurrentZone);
  auto& maps = harness.collect(topics::kTopologicalMap);
  auto& transforms = harness.collect(topics::kTf);
  harness.advance_s(1.0);
  ASSERT_EQ(zones.size(), 1u);
  EXPECT_EQ(zones[0].zone_id, 1u);
  EXPECT_EQ(zones[0].T_map_zone, Pose2{});
  EXPECT_EQ(maps.size(), 1u);
  EXPECT_GE(transforms.size(), 20u);
  EXPECT_EQ(transforms.back().transforms.at(0).frame_id, "map");
  EXPECT_EQ(transforms.back().transforms.at(0).child_frame_id, "odom");
}

TEST_F(TopoGraphNodeTest, RunsTheProtocolOfTwoRooms) {
  Harness harness("topoGraph", config_);
  auto& zones = harness.collect(topics::kCurrentZone);
  auto& maps = harness.collect(topics::kTopologicalMap);
  auto& corrections = harness.collect(topics::kPoseCorrection);
  EXPECT_EQ(harness.call(topics::kFixRoom, fix1())->room, 1u);
  EXPECT_EQ(harness.call(topics::kEnterZone, enter2())->zone_id, 2u);
  EXPECT_EQ(zones.back().valid_from_ns, from_seconds(0.5));
  EXPECT_FALSE(zones.back().room);
  EXPECT_EQ(harness.call(topics::kFixRoom, fix2())->room, 2u);
  ASSERT_EQ(corrections.size(), 1u);
  EXPECT_EQ(corrections[0].reason, PoseCorrection::Reason::kCommonDoor);
  EXPECT_EQ(zones.back().room, RoomId{2});
  EXPECT_EQ(zones.back().T_map_zone, corrections[0].T_map_odom);
  EXPECT_EQ(maps.back().rooms.size(), 2u);
  EXPECT_EQ(maps.back().doors.at(0).kind, DoorKind::kPassage);
}

TEST_F(TopoGraphNodeTest, AnswersARepeatedRequestWithoutAnnouncingAnything) {
  Harness harness("topoGraph", config_);
  harness.call(topics::kFixRoom, fix1());
  auto& maps = harness.collect(topics::kTopologicalMap);
  auto& zones = harness.collect(topics::kCurrentZone);
  harness.advance_s(0.1);
  maps.clear();
  zones.clear();
  EXPECT_EQ(harness.call(topics::kFixRoom, fix1())->room, 1u);
  EXPECT_TRUE(maps.empty());
  EXPECT_TRUE(zones.empty());
}

// Whoever dies between any two steps: a new process on the same file knows zone, map and answers.
TEST_F(TopoGraphNodeTest, GoesOnAfterARestartBetweenAnyTwoSteps) {
  CurrentZone zone;
  const auto restart = [&](auto&& step) {
    Harness harness("topoGraph", config_);
    auto& zones = harness.collect(topics::kCurrentZone);
    step(harness);
    harness.advance_s(0.1);
    zone = zones.back();
  };
  restart([](Harness& h) { EXPECT_EQ(h.call(topics::kFixRoom, fix1())->room, 1u); });
  restart([](Harness& h) { EXPECT_EQ(h.call(topics::kFixRoom, fix1())->room, 1u); });
  EXPECT_EQ(zone.room, RoomId{1});
  restart([](Harness& h) { EXPECT_EQ(h.call(topics::kEnterZone, enter2())->zone_id, 2u); });
  restart([](Harness& h) { EXPECT_EQ(h.call(topics::kEnterZone, enter2())->zone_id, 2u); });
  EXPECT_EQ(zone.via_door, DoorId{1});
  restart([](Harness& h) { EXPECT_EQ(h.call(topics::kFixRoom, fix2())->room, 2u); });
  const CurrentZone before = zone;
  restart([](Harness& h) { EXPECT_EQ(h.call(topics::kFixRoom, fix2())->room, 2u); });
  EXPECT_EQ(zone, before);
  const TopologicalMap map = load_map(config_.map_file);
  EXPECT_EQ(map.rooms.size(), 2u);
  EXPECT_EQ(map.version, 2u);
  restart([](Harness& h) {
    EXPECT_TRUE(h.call(topics::kMarkDoor, {call(4), 1, DoorKind::kBlocked})->accepted);
  });
}

TEST_F(TopoGraphNodeTest, WritesBeforeItAnswers) {
  Harness harness("topoGraph", config_);
  std::size_t rooms_on_disk = 0;
  harness.bus_as("explorer").subscribe<FixRoomReply>(topics::kFixRoom.reply, [&](const FixRoomReply&) {
    rooms_on_disk = load_map(config_.map_file).rooms.size();
  });
  harness.call(topics::kFixRoom, fix1());
  EXPECT_EQ(rooms_on_disk, 1u);
}

TEST_F(TopoGraphNodeTest, RefusesWhatItCannotKeep) {
  Harness harness("topoGraph", config_);
  harness.node();
  fs::create_directory(config_.map_file + ".tmp");
  fs::remove(config_.map_file + ".journal");
  fs::create_directory(config_.map_file + ".journal");
  const auto refused = harness.call(topics::kFixRoom, fix1());
  ASSERT_TRUE(refused);
  EXPECT_FALSE(refused->accepted);
  EXPECT_NE(refused->message.find("map.yaml"), std::string::npos);
  fs::remove(config_.map_file + ".tmp");
  fs::remove(config_.map_file + ".journal");
  EXPECT_TRUE(harness.call(topics::kFixRoom, fix1())->accepted);
  EXPECT_EQ(load_map(config_.map_file).rooms.size(), 1u);  // the first try had left nothing in memory either
}

TEST_F(TopoGraphNodeTest, CorrectsThePoseByRecentModels) {
  Harness harness("topoGraph", config_);
  auto& corrections = harness.collect(topics::kPoseCorrection);
  auto& zones = harness.collect(topics::kCurrentZone);
  harness.call(topics::kFixRoom, fix1());
  RoomEstimate later = fix1().estimate;
  later.recent = kDrift * later.rectangle;
  later.recent_stamp_ns = later.stamp_ns + 1;
  harness.publish(topics::kRoomEstimate, later);
  harness.advance_s(0.1);
  ASSERT_EQ(corrections.size(), 1u);
  EXPECT_EQ(corrections[0].reason, PoseCorrection::Reason::kModelDeviation);
  expect_near(corrections[0].deviation, kDrift, 1e-9);
  expect_near(zones.back().T_map_zone * kDrift, {}, 1e-9);
  EXPECT_EQ(zones.back().zone_id, 1u);
  EXPECT_EQ(load_state(config_.map_file).session.zone, zones.back());
}

TEST_F(TopoGraphNodeTest, KeepsThePreviousMapWhenItStartsANewOne) {
  { Harness("topoGraph", config_).call(topics::kFixRoom, fix1()); }
  config_.resume = false;
  { Harness("topoGraph", config_).node(); }
  EXPECT_TRUE(load_map(config_.map_file).rooms.empty());
  EXPECT_EQ(load_map(config_.map_file + ".previous").rooms.size(), 1u);
}

TEST_F(TopoGraphNodeTest, RefusesAFolderAsMapFileAndLeavesItWhereItIs) {
  config_.map_file = folder_;
  for (const bool resume : {false, true}) {
    config_.resume = resume;
    Harness harness("topoGraph", config_);
    EXPECT_THROW(harness.node(), MapFileError);
    EXPECT_TRUE(fs::is_directory(folder_));
  }
}

TEST_F(TopoGraphNodeTest, LeavesOneWholeFileWhenItStops) {
  {
    Harness harness("topoGraph", config_);
    harness.call(topics::kFixRoom, fix1());
    EXPECT_TRUE(fs::exists(config_.map_file + ".journal"));
  }
  EXPECT_FALSE(fs::exists(config_.map_file + ".journal"));
  EXPECT_EQ(load_map(config_.map_file).rooms.size(), 1u);
}

TEST_F(TopoGraphNodeTest, GoesOnFromTheJournalOfOneThatDied) {
  const std::string left = folder_ / "left.yaml";
  {
    Harness harness("topoGraph", config_);
    harness.call(topics::kFixRoom, fix1());
    harness.call(topics::kEnterZone, enter2());
    fs::copy_file(config_.map_file, left);
    fs::copy_file(config_.map_file + ".journal", left + ".journal");
  }
  std::ofstream(left + ".journal", std::ios::app)
      << "---  # record 3, 99 bytes\ncha";  // it died writing this
  EXPECT_TRUE(parse_map_file(read_if_there(left).value(), left).map.rooms.empty());
  config_.map_file = left;
  Harness harness("topoGraph", config_);
  auto& zones = harness.collect(topics::kCurrentZone);
  harness.node();
  harness.advance_s(0.1);
  EXPECT_EQ(zones.back().zone_id, 2u);
  EXPECT_EQ(harness.call(topics::kFixRoom, fix2())->room, 2u);
}

TEST_F(TopoGraphNodeTest, RefusesToStartFromADamagedFile) {
  { Harness("topoGraph", config_).node(); }
  fs::resize_file(config_.map_file, fs::file_size(config_.map_file) / 2);
  Harness harness("topoGraph", config_);
  EXPECT_THROW(harness.node(), MapFileError);
}

TEST_F(TopoGraphNodeTest, KeepsNothingWithoutAFile) {
  config_.map_file.clear();
  Harness harness("topoGraph", config_);
  EXPECT_EQ(harness.call(topics::kFixRoom, fix1())->room, 1u);
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace enfilade::topo_graph
