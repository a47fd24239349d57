// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/node/explorer_node.hpp"

#include <gtest/gtest.h>

#include "tests/support/node_harness.hpp"
#include "tests/unit/components/explorer/synthetic_room.hpp"

namespace enfilade::explorer {
namespace {

using Harness = NodeHarness<ExplorerNode, ExplorerConfig>;
constexpr ZoneTag kTag{1, 1, 5};

void publish_world(Harness& harness) {
  harness.publish(topics::kCurrentZone, {.zone_id = 1});
  harness.publish(topics::kMotorState, {.odom_boot = 5});
  harness.publish(topics::kTf, {{{harness.now_ns(), "odom", "zone", {}}}});
  harness.publish(topics::kOdom, {.stamp_ns = harness.now_ns(), .T_odom_base = to_transform3({1, 1, 0})});
}

TEST(ExplorerNode, WaitsUntilZoneMotorOdometryAndGridAreThere) {
  Harness harness("explorer", {});
  auto& sweeps = harness.collect(topics::kSweepCommand);
  auto& states = harness.collect(topics::kExplorationState);
  harness.node();
  publish_world(harness);
  harness.advance_s(1.0);
  EXPECT_TRUE(sweeps.empty());
  ASSERT_FALSE(states.empty());
  EXPECT_EQ(states.back().phase, ExplorationPhase::kWaiting);

  harness.publish(topics::kGridChange, {.tag = kTag, .sequence = 0, .resolution_m = 0.05});
  harness.advance_s(0.3);
  ASSERT_EQ(sweeps.size(), 1u);
  EXPECT_EQ(sweeps[0].action, SweepAction::kSweep);
  EXPECT_EQ(states.back().phase, ExplorationPhase::kScanning);
  EXPECT_EQ(states.back().tag, kTag);
}

TEST(ExplorerNode, TakesAGridThatBeganBeforeItFromASnapshot) {
  Harness harness("explorer", {});
  auto& sweeps = harness.collect(topics::kSweepCommand);
  auto& asked = harness.collect(topics::kGridSnapshot.request);
  serve<GridSnapshotRequest, GridSnapshotReply>(
      harness.bus_as("gridBuilder"), topics::kGridSnapshot, [](const GridSnapshotRequest&) {
        const auto cells = SyntheticRoom().room(0, 0, 3, 3).cells();
        return GridSnapshotReply{
            .call = {}, .snapshot = {.tag = kTag, .sequence = 12, .resolution_m = 0.05, .cells = cells}};
      });
  harness.node();
  publish_world(harness);
  harness.advance_s(0.5);
  EXPECT_EQ(asked.size(), 1u);
  EXPECT_EQ(sweeps.size(), 1u);

  harness.publish(topics::kGridChange, {.tag = kTag, .sequence = 20, .resolution_m = 0.05});
  harness.advance_s(0.5);
  EXPECT_EQ(asked.size(), 2u);
}

/// Sweeps as soon as it is told to.
void play_motor(Harness& harness) {
  harness.bus_as("motorControl")
      .subscribe<SweepCommand>(topics::kSweepCommand, [&harness](const SweepCommand& c) {
        const bool park = c.action == SweepAction::kPark;
        harness.publish(topics::kMotorState, {.odom_boot = 5,
                                              .sweep_id = c.sweep_id,
                                              .phase = park ? SweepPhase::kParked : SweepPhase::kDone,
                                              .sweep_end_ns = park ? 0 : harness.now_ns()});
      });
}

TEST(ExplorerNode, DrivesOnlyWhileItHearsOdometryAndSensor) {
  Harness harness("explorer", {});
  auto& velocities = harness.collect(topics::kCmdVel);
  play_motor(harness);
  harness.node();
  publish_world(harness);
  harness.publish(
      topics::kGridChange,
      {.tag = kTag, .sequence = 0, .resolution_m = 0.05, .cells = SyntheticRoom().room(0, 0, 3, 3).cells()});
  // After the first sweep it turns towards what was behind it.
  for (int i = 0; i < 400; ++i) {
    harness.publish(topics::kOdom, {.stamp_ns = harness.now_ns(), .T_odom_base = to_transform3({1, 1, 0})});
    harness.publish(topics::kPoints,
                    {.stamp_ns = harness.now_ns(), .frame_id = "base_link", .points = {{2, 0, 0.6F}}});
    harness.advance_s(0.02);
  }
  ASSERT_FALSE(velocities.empty());
  EXPECT_NE(velocities.back(), VelocityCommand{});
  harness.advance_s(1.5);
  EXPECT_EQ(velocities.back(), VelocityCommand{});
}

}  // namespace
}  // namespace enfilade::explorer
