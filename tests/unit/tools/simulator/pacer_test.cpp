// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/node/pacer.hpp"

#include <gtest/gtest.h>

namespace enfilade::simulator {
namespace {

class HandClock : public Clock {
 public:
  StampNs now_ns() const override { return now; }
  StampNs now = from_seconds(1000.0);
};

/// A world that does what the pacer allows, asked every 5 ms of wall time.
struct Rig {
  explicit Rig(CreditPacerConfig config) : pacer(config, clock) {}

  void run_for(
      double wall_s, const std::function<void()>& each = [] {}) {
    for (int i = 0; i < wall_s * 200; ++i) {
      clock.now += 5'000'000;
      each();
      world_ns = std::max(world_ns, pacer.allowed_ns(world_ns));
    }
  }
  void credit(const char* name, StampNs done_ns) { pacer.hear({name, done_ns}); }
  void all_keep_up() {
    for (const char* name : {"laser3D", "motorControl", "gridBuilder"}) credit(name, world_ns);
  }

  HandClock clock;
  CreditPacer pacer;
  StampNs world_ns = 0;
};

TEST(CreditPacer, CreepsUntilAllReadersWereHeard) {
  Rig rig({});
  rig.run_for(2.0);
  EXPECT_FALSE(rig.pacer.started());
  EXPECT_NEAR(seconds(rig.world_ns), 20 * 0.005, 0.006);  // ten steps a second
  rig.credit("laser3D", 0);
  rig.credit("motorControl", 0);
  rig.run_for(0.5);
  EXPECT_FALSE(rig.pacer.started());
  rig.credit("gridBuilder", 0);
  rig.run_for(0.01);
  EXPECT_TRUE(rig.pacer.started());
}

TEST(CreditPacer, StartsWithoutReadersAfterTheWait) {
  Rig rig({.wait_for_readers_s = 3.0});
  rig.run_for(2.9);
  EXPECT_FALSE(rig.pacer.started());
  rig.run_for(0.2);
  EXPECT_TRUE(rig.pacer.started());
}

TEST(CreditPacer, GoesAtTheSpeedAskedForWhenReadersKeepUp) {
  for (const double speed : {0.5, 1.0, 4.0}) {
    Rig rig({.speed = speed});
    rig.all_keep_up();
    rig.run_for(0.1, [&] { rig.all_keep_up(); });
    const StampNs from_ns = rig.world_ns;
    rig.run_for(10.0, [&] { rig.all_keep_up(); });
    EXPECT_NEAR(seconds(rig.world_ns - from_ns), 10.0 * speed, 0.01 * speed);
  }
}

TEST(CreditPacer, RunsNeverMoreThanTheWindowAheadOfTheSlowestReader) {
  Rig rig({.speed = 0.0});
  StampNs slow_ns = 0;
  rig.all_keep_up();
  rig.run_for(5.0, [&] {
    rig.all_keep_up();
    slow_ns += 1'000'000;  // five times slower than wall time
    rig.credit("roomDetector", slow_ns);
    EXPECT_LE(rig.world_ns, slow_ns + 100'000'000);
  });
  EXPECT_NEAR(seconds(rig.world_ns), 1.1, 0.01);
}

TEST(CreditPacer, WaitsForADeadReaderOnlyForItsLifetime) {
  Rig rig({});
  rig.all_keep_up();
  const auto all_but_one = [&] {
    rig.credit("laser3D", rig.world_ns);
    rig.credit("motorControl", rig.world_ns);
  };
  rig.run_for(0.9, all_but_one);
  EXPECT_LE(seconds(rig.world_ns), 0.1);
  rig.run_for(5.0, all_but_one);
  EXPECT_NEAR(seconds(rig.world_ns), 5.0, 0.15);
}

TEST(CreditPacer, DoesNotCatchUpWhatSlowReadersCost) {
  Rig rig({});
  rig.all_keep_up();
  rig.run_for(3.0, [&] {
    for (const char* name : {"laser3D", "motorControl", "gridBuilder"}) rig.credit(name, 0);
  });
  EXPECT_LE(seconds(rig.world_ns), 0.1);
  const StampNs from_ns = rig.world_ns;
  rig.run_for(1.0, [&] { rig.all_keep_up(); });
  EXPECT_NEAR(seconds(rig.world_ns - from_ns), 1.0, 0.11);
}

TEST(FollowingPacer, AllowsWhatItsClockSays) {
  HandClock clock;
  FollowingPacer pacer(clock);
  EXPECT_EQ(pacer.allowed_ns(0), clock.now);
}

}  // namespace
}  // namespace enfilade::simulator
