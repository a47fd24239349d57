// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/simulation.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/tools/simulator/test_worlds.hpp"

namespace enfilade::simulator {
namespace {

World small_flat() {
  FloorPlan plan = test::two_rooms();
  plan.doors.push_back(test::east_door(1));
  plan.furniture.push_back({circle_outline({-1.0, 0.8}, 0.4), 0.0, 1.0, false});
  return build_world(plan);
}

std::vector<Simulation::Step> run(std::uint64_t seed, int steps) {
  SimulationConfig config;
  config.seed = seed;
  Simulation simulation(small_flat(), config);
  simulation.actuate({1.0, 1.5, 0.8});
  std::vector<Simulation::Step> all;
  for (int i = 0; i < steps; ++i) all.push_back(simulation.step());
  return all;
}

bool same(const std::vector<Simulation::Step>& a, const std::vector<Simulation::Step>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(a[i].encoders == b[i].encoders) || a[i].scan.has_value() != b[i].scan.has_value()) return false;
    if (a[i].scan && a[i].scan->ranges_m != b[i].scan->ranges_m) return false;
  }
  return true;
}

TEST(Simulation, IsTheSameForTheSameSeedOnly) {
  EXPECT_TRUE(same(run(7, 200), run(7, 200)));
  EXPECT_FALSE(same(run(7, 200), run(8, 200)));
}

TEST(Simulation, CompletesFortyLinesASecondStampedAtTheirFirstBeam) {
  StampNs expected_ns = 0;
  for (const Simulation::Step& step : run(1, 200)) {
    if (!step.scan) continue;
    EXPECT_EQ(step.scan->stamp_ns, expected_ns);
    EXPECT_EQ(step.encoders.stamp_ns, expected_ns + 20'000'000);
    expected_ns += 25'000'000;
  }
  EXPECT_EQ(expected_ns, 1'000'000'000);
}

TEST(Simulation, TheRollMotorFollowsItsCommandAndStopsAtItsEnd) {
  Simulation simulation(small_flat(), test::without_noise());
  simulation.actuate({0.0, 0.0, 1.0});
  for (int i = 0; i < 200; ++i) simulation.step();
  EXPECT_NEAR(simulation.encoders().roll_rad, 1.0, 0.02);
  EXPECT_NEAR(simulation.encoders().roll_rad_s, 1.0, 1e-9);
  for (int i = 0; i < 400; ++i) simulation.step();
  EXPECT_NEAR(simulation.encoders().roll_rad, 1.75, 1e-9);
}

TEST(Simulation, MotorsStopWhenTheirCommandsCease) {
  SimulationConfig config = test::without_noise();
  config.command_timeout_s = 0.25;
  Simulation simulation(small_flat(), config);
  for (int i = 0; i < 200; ++i) {
    simulation.actuate({2.0, 2.0, 1.0});
    simulation.step();
  }
  const double driven_m = simulation.ground_truth().path_length_m;
  EXPECT_NEAR(driven_m, 0.16, 0.01);
  for (int i = 0; i < 400; ++i) simulation.step();
  EXPECT_NEAR(simulation.ground_truth().path_length_m, driven_m + 0.16 * 0.25, 0.01);
  EXPECT_EQ(simulation.encoders().roll_rad_s, 0.0);
}

TEST(Simulation, TruthMeasuresTheWayDriven) {
  Simulation simulation(small_flat(), test::without_noise());
  simulation.actuate({2.0, 2.0, 0.0});
  for (int i = 0; i < 800; ++i) simulation.step();
  const GroundTruth truth = simulation.ground_truth();
  EXPECT_NEAR(truth.path_length_m, truth.T_world_base.x_m, 1e-9);
  EXPECT_NEAR(truth.path_length_m, 0.16 * 4.0, 0.01);
}

}  // namespace
}  // namespace enfilade::simulator
