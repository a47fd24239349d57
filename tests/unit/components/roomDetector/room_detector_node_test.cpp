// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/node/room_detector_node.hpp"

#include <deque>

#include <gtest/gtest.h>

#include "tests/support/etc_folder.hpp"
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

ScanHits line_at(StampNs stamp_ns) {
  return {.tag = kTag, .stamp_ns = stamp_ns, .T_zone_base = {}, .hits = {{2.0F, 0.1F, 1.0F, 1}}};
}

TEST_F(RoomDetectorNodeTest, PublishesTheRoomAtTheInstantThatCompletesALine) {
  harness.advance_s(0.26);
  for (const bool hits_first : {false, true}) {
    estimates.clear();
    const StampNs stamp_ns = hits_first ? 600 : 500;
    GridChange change = room_change(hits_first ? 2 : 1);
    change.stamp_ns = stamp_ns;
    if (hits_first) harness.publish(topics::kScanHits, line_at(stamp_ns));
    if (!hits_first) harness.publish(topics::kGridChange, change);
    harness.advance_s(0.0);
    EXPECT_TRUE(estimates.empty()) << hits_first;  // half of the line is missing
    if (!hits_first) harness.publish(topics::kScanHits, line_at(stamp_ns));
    if (hits_first) harness.publish(topics::kGridChange, change);
    harness.advance_s(0.0);
    ASSERT_EQ(estimates.size(), 1u) << hits_first;
    EXPECT_EQ(estimates[0].stamp_ns, stamp_ns);
    EXPECT_EQ(estimates[0].grid_sequence, change.sequence);
  }
}

TEST_F(RoomDetectorNodeTest, BringsWhatNoLineHasBroughtAtItsPeriod) {
  harness.advance_s(0.26);
  harness.publish(topics::kGridChange, room_change(1));
  harness.publish(topics::kScanHits, line_at(500));
  harness.advance_s(0.0);
  harness.publish(topics::kGridChange, room_change(2));  // the free part of the same line
  harness.advance_s(0.0);
  EXPECT_EQ(estimates.size(), 1u);
  harness.advance_s(0.25);
  ASSERT_EQ(estimates.size(), 2u);
  EXPECT_EQ(estimates[1].grid_sequence, 2u);
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

/// First come, first served, as in a process; runs when the test says so.
struct QueueExecutor : Executor {
  void post(std::function<void()> work) override { queue.push_back(std::move(work)); }
  void every(StampNs, std::function<void()>) override {}
  void every_wall(StampNs, std::function<void()>) override {}
  void on_exception(ExceptionHandler) override {}
  void run_all() {
    for (; !queue.empty(); queue.pop_front()) queue.front()();
  }

  std::deque<std::function<void()>> queue;
};

struct Surroundings : Clock, Log, Lifecycle {
  StampNs now_ns() const override { return 0; }
  void debug(std::string_view) override {}
  void info(std::string_view) override {}
  void warn(std::string_view) override {}
  void error(std::string_view) override {}
  void go_to_emergency(std::string) override {}
  void go_to_restore() override {}
  bool in_emergency() const override { return false; }
};

TEST(RoomDetectorNodeThatLagsBehind, TakesTheLinesThatWaitTogether) {
  QueueExecutor executor;
  Surroundings around;
  InProcessNetwork network;
  const auto queue = [&](int, std::function<void()> work) { executor.post(std::move(work)); };
  InProcessBus bus(network, "roomDetector", 0, queue), grid(network, "gridBuilder", 1, queue),
      reader(network, "explorer", 2, queue);
  RoomDetectorNode node({"roomDetector", bus, around, executor, around, around}, {});
  node.initialize();
  executor.run_all();
  const auto changes = grid.advertise(topics::kGridChange);
  const auto hits = grid.advertise(topics::kScanHits);
  std::vector<RoomEstimate> estimates;
  reader.subscribe<RoomEstimate>(topics::kRoomEstimate,
                                 [&](const RoomEstimate& e) { estimates.push_back(e); });
  for (std::uint64_t i = 1; i <= 5; ++i) {
    GridChange change = room_change(i);
    change.stamp_ns = static_cast<StampNs>(100 * i);
    hits.publish(line_at(change.stamp_ns));
    changes.publish(std::move(change));
  }
  executor.run_all();
  ASSERT_EQ(estimates.size(), 1u);
  EXPECT_EQ(estimates[0].stamp_ns, 500);
}

TEST(RoomDetectorConfiguration, ShipsItsDefaults) {
  const RoomDetectorNodeConfig defaults,
      shipped = load_config<RoomDetectorNodeConfig>(enfilade::test::etc_folder() + "roomDetector.yaml");
  EXPECT_EQ(shipped.period.compute_s, defaults.period.compute_s);
  EXPECT_EQ(shipped.detector.votes.toll_share, defaults.detector.votes.toll_share);
  EXPECT_EQ(shipped.detector.door_finder.sill_m, defaults.detector.door_finder.sill_m);
  const auto config = load_config<RoomDetectorNodeConfig>(enfilade::test::etc_folder() + "roomDetector.yaml",
                                                          {"step_m=0.27"});
  EXPECT_EQ(config.detector.hough.step_m, 0.27);
  EXPECT_THROW(
      load_config<RoomDetectorNodeConfig>(enfilade::test::etc_folder() + "roomDetector.yaml", {"step_m=0.6"}),
      ConfigError);
}

}  // namespace
}  // namespace enfilade::room_detector
