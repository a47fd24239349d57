// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/zone_gate.hpp"

#include <gtest/gtest.h>

namespace enfilade::grid_builder {
namespace {

CurrentZone zone(std::uint32_t id, StampNs valid_from_ns = 0) {
  CurrentZone z;
  z.zone_id = id;
  z.valid_from_ns = valid_from_ns;
  return z;
}

MotorState sweeping(StampNs stamp, StampNs start, std::uint32_t boot = 7) {
  return {stamp, boot, 1, SweepPhase::kSweeping, start, 0, false};
}
MotorState done(StampNs stamp, StampNs start, StampNs end) {
  return {stamp, 7, 1, SweepPhase::kDone, start, end, false};
}
MotorState approaching(StampNs stamp) { return {stamp, 7, 2, SweepPhase::kApproaching, 0, 0, false}; }

TEST(ZoneGate, OpensWhenZoneAndBootAreKnown) {
  ZoneGate gate({}, 40);
  EXPECT_FALSE(gate.take(zone(3)));
  EXPECT_FALSE(gate.open());
  EXPECT_TRUE(gate.take(sweeping(100, 100)));
  EXPECT_EQ(gate.tag(), (ZoneTag{3, 40, 7}));
}

TEST(ZoneGate, StartsAnEpochForEachNewZoneOnly) {
  ZoneGate gate({}, 1);
  (void)gate.take(sweeping(100, 100));
  EXPECT_TRUE(gate.take(zone(1)));
  gate.next_sequence();
  EXPECT_FALSE(gate.take(zone(1)));
  EXPECT_EQ(gate.sequence(), 1u);
  EXPECT_TRUE(gate.take(zone(2)));
  EXPECT_EQ(gate.tag(), (ZoneTag{2, 2, 7}));
  EXPECT_EQ(gate.sequence(), 0u);
}

TEST(ZoneGate, StartsAnEpochWhenTheOdometryBootsAgain) {
  ZoneGate gate({}, 1);
  (void)gate.take(zone(1));
  (void)gate.take(sweeping(100, 100));
  EXPECT_FALSE(gate.take(sweeping(120, 100)));
  EXPECT_TRUE(gate.take(sweeping(10, 10, 8)));
  EXPECT_EQ(gate.tag(), (ZoneTag{1, 2, 8}));
}

TEST(ZoneGate, DropsLinesFromBeforeTheZone) {
  ZoneGate gate({}, 1);
  (void)gate.take(zone(2, 150));
  (void)gate.take(sweeping(100, 100));
  EXPECT_FALSE(gate.accepts(149));
  EXPECT_TRUE(gate.accepts(150));
}

TEST(ZoneGate, TakesLinesOfASweepAlsoAfterItHasEnded) {
  ZoneGate gate({}, 1);
  (void)gate.take(zone(1));
  (void)gate.take(approaching(50));
  EXPECT_FALSE(gate.accepts(60));
  (void)gate.take(sweeping(100, 100));
  EXPECT_FALSE(gate.accepts(99));
  EXPECT_TRUE(gate.accepts(100));
  EXPECT_TRUE(gate.accepts(900));  // the end is not known yet
  (void)gate.take(done(200, 100, 195));
  EXPECT_TRUE(gate.accepts(195));
  EXPECT_FALSE(gate.accepts(196));
  (void)gate.take(approaching(300));
  EXPECT_TRUE(gate.accepts(150));
  EXPECT_FALSE(gate.accepts(290));
}

TEST(ZoneGate, BelievesOnlyWhatItSawOfASweepWhoseEndItMissed) {
  ZoneGate gate({}, 1);
  (void)gate.take(zone(1));
  (void)gate.take(sweeping(100, 100));
  (void)gate.take(sweeping(150, 100));
  (void)gate.take(approaching(300));
  EXPECT_TRUE(gate.accepts(150));
  EXPECT_FALSE(gate.accepts(200));
}

TEST(ZoneGate, TakesEverythingWhenStationary) {
  ZoneGate gate({.stationary = true}, 1);
  EXPECT_EQ(gate.tag(), (ZoneTag{1, 1, 0}));
  EXPECT_TRUE(gate.accepts(-5));
  EXPECT_FALSE(gate.take(zone(9)));
  EXPECT_FALSE(gate.take(sweeping(1, 1)));
}

}  // namespace
}  // namespace enfilade::grid_builder
