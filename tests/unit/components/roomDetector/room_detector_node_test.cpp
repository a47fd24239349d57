// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/node/room_detector_node.hpp"

#include <gtest/gtest.h>

#include "tests/support/node_harness.hpp"
#include "tests/unit/components/roomDetector/ideal_room.hpp"

namespace enfilade::room_detector {
namespace {

constexpr ZoneTag kTag{1, 1, 1};

GridChange room_change(std::uint64_t sequence) {
  GridChange change = test::ideal_room([](double, double, double) { return CellState::kOccupied; });
  change.tag = kTag;
  change.sequence = sequence;
  change.stamp_ns = 500;
  return change;
}

struct RoomDetectorNodeTest : ::testing::Test {
  NodeHarness<RoomDetectorNode, RoomDetectorNodeConfig> harness{"roomDetector", {}};
  std::vector<RoomEstimate>& estimates = harness.collect(topics::kRoomEstimate);
  std::vector<GridSnapshotRequest>& requests = harness.collect(topics::kGridSnapshot.request);
};

TEST_F(RoomDetectorNodeTest, PublishesTheRoomOnceForEachChange) {
  harness.advance_s(0.1);
  harness.publish(topics::kGridChange, room_change(1));
  harness.advance_s(2.0);
  ASSERT_EQ(estimates.size(), 1u);
  EXPECT_TRUE(estimates[0].found);
  EXPECT_EQ(estimates[0].tag, kTag);
  EXPECT_EQ(estimates[0].grid_sequence, 1u);
  EXPECT_EQ(estimates[0].stamp_ns, 500);
  EXPECT_NEAR(estimates[0].rectangle.width_m, 4.05, 0.03);
  EXPECT_NEAR(estimates[0].rectangle.height_m, 3.05, 0.03);
}

TEST_F(RoomDetectorNodeTest, AsksForASnapshotWhenAChangeIsMissing) {
  harness.advance_s(0.1);
  requests.clear();
  harness.publish(topics::kGridChange, room_change(4));
  harness.advance_s(0.5);
  EXPECT_TRUE(estimates.empty());
  ASSERT_FALSE(requests.empty());
  harness.publish(topics::kGridSnapshot.reply, GridSnapshotReply{requests.back().call, room_change(4)});
  harness.advance_s(0.5);
  ASSERT_EQ(estimates.size(), 1u);
  EXPECT_EQ(estimates[0].grid_sequence, 4u);
}

TEST_F(RoomDetectorNodeTest, DropsReturnsOfAnotherGrid) {
  harness.advance_s(0.1);
  harness.publish(topics::kGridChange, room_change(1));
  harness.advance_s(0.5);
  harness.publish(topics::kScanHits, ScanHits{.tag = {2, 1, 1}, .stamp_ns = 900});
  harness.advance_s(0.5);
  EXPECT_EQ(estimates.size(), 1u);
}

TEST(RoomDetectorConfiguration, ShipsItsDefaults) {
  const RoomDetectorNodeConfig defaults,
      shipped = load_config<RoomDetectorNodeConfig>(ENFILADE_SOURCE_DIR "/etc/roomDetector.yaml");
  EXPECT_EQ(shipped.period.compute_s, defaults.period.compute_s);
  EXPECT_EQ(shipped.detector.votes.toll_share, defaults.detector.votes.toll_share);
  EXPECT_EQ(shipped.detector.door_finder.sill_m, defaults.detector.door_finder.sill_m);
  const auto config =
      load_config<RoomDetectorNodeConfig>(ENFILADE_SOURCE_DIR "/etc/roomDetector.yaml", {"step_m=0.27"});
  EXPECT_EQ(config.detector.hough.step_m, 0.27);
  EXPECT_THROW(
      load_config<RoomDetectorNodeConfig>(ENFILADE_SOURCE_DIR "/etc/roomDetector.yaml", {"step_m=0.6"}),
      ConfigError);
}

}  // namespace
}  // namespace enfilade::room_detector
