// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/node/simulator_node.hpp"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "interfaces/runtime/composed_system.hpp"
#include "interfaces/topics/topics.hpp"
#include "tests/support/etc_folder.hpp"
#include "tests/unit/tools/simulator/temporary_file.hpp"

namespace enfilade::simulator {
namespace {

const std::string kEtc = enfilade::test::etc_folder();

SimulatorConfig shipped_config() {
  SimulatorConfig config = load_config<SimulatorConfig>(kEtc + "simulator.yaml");
  config.world = resolve_world(config.world, kEtc + "simulator.yaml");
  config.simulation.command_timeout_s = 0.0;
  return config;
}

TEST(SimulatorConfig, TheShippedFileHoldsEveryKeyWithItsDefault) {
  const test::TemporaryFile nothing("simulator.yaml", "{}\n");
  std::string shipped, defaults;
  load_config<SimulatorConfig>(kEtc + "simulator.yaml", {}, &shipped);
  load_config<SimulatorConfig>(nothing.path(), {}, &defaults);
  EXPECT_EQ(shipped, defaults);
  const YAML::Node file = YAML::LoadFile(kEtc + "simulator.yaml");
  const YAML::Node all = YAML::Load(defaults);
  EXPECT_EQ(file.size(), all.size());
  for (const auto& entry : all) {
    if (!entry.second.IsMap()) continue;
    EXPECT_EQ(file[entry.first.Scalar()].size(), entry.second.size()) << entry.first;
  }
}

TEST(SimulatorConfig, AWorldIsLookedForBesideTheConfiguration) {
  EXPECT_EQ(resolve_world("worlds/paper_two_rooms.yaml", kEtc + "simulator.yaml"),
            kEtc + "worlds/paper_two_rooms.yaml");
  EXPECT_EQ(resolve_world("no/such.yaml", kEtc + "simulator.yaml"), "no/such.yaml");
}

TEST(SimulatorNode, SaysWhichWorldCannotBeLivedIn) {
  const test::TemporaryFile file(
      "closet.yaml",
      "rooms:\n  - {name: closet, width_m: 0.5, height_m: 0.5}\nstart: {room: closet, x_m: 0.2}\n");
  SimulatorConfig config;
  config.world = file.path();
  ComposedSystem system;
  system.add("simulator", config.period, [&config](const NodeContext& context) {
    return std::make_unique<SimulatorNode>(context, config);
  });
  try {
    system.initialize();
    FAIL() << "the robot was put into a wall";
  } catch (const ConfigError& e) {
    EXPECT_NE(std::string(e.what()).find("does not fit at the start pose"), std::string::npos) << e.what();
  }
}

struct Heard {
  std::vector<ClockTick> ticks;
  std::vector<SimEncoders> encoders;
  std::vector<LaserScan> scans;
  std::vector<GroundTruth> truths;
};

/// One second of the shipped world, composed; motorControl is played by the test.
Heard one_second() {
  const SimulatorConfig config = shipped_config();
  Heard heard;
  ComposedSystem system;
  Bus& tool = system.tool_bus();
  tool.subscribe<ClockTick>(topics::kClock, [&](const ClockTick& m) { heard.ticks.push_back(m); });
  tool.subscribe<SimEncoders>(topics::kSimEncoders,
                              [&](const SimEncoders& m) { heard.encoders.push_back(m); });
  tool.subscribe<LaserScan>(topics::kSimScan, [&](const LaserScan& m) { heard.scans.push_back(m); });
  tool.subscribe<GroundTruth>(topics::kGroundTruth, [&](const GroundTruth& m) { heard.truths.push_back(m); });
  const auto actuation = system.bus_as("motorControl").advertise(topics::kSimActuation);
  system.add("simulator", config.period, [&config](const NodeContext& context) {
    return std::make_unique<SimulatorNode>(context, config);
  });
  system.initialize();
  actuation.publish({.left_wheel_rad_s = 1.0, .right_wheel_rad_s = 1.0, .roll_rad_s = 0.5});
  system.run_until([] { return false; }, from_seconds(1.0));
  return heard;
}

TEST(SimulatorNode, FollowsVirtualTimeAtTheRatesOfTheTopicTable) {
  const Heard heard = one_second();
  EXPECT_EQ(heard.ticks.size(), 200u);
  EXPECT_EQ(heard.encoders.size(), 200u);
  EXPECT_EQ(heard.scans.size(), 40u);
  EXPECT_EQ(heard.truths.size(), 20u);
  EXPECT_EQ(heard.ticks.back().now_ns, from_seconds(1.0));
  EXPECT_EQ(heard.scans.front().ranges_m.size(), 1081u);
  EXPECT_EQ(heard.scans.front().frame_id, "laser_scan");
}

TEST(SimulatorNode, DoesWhatTheActuationSays) {
  const Heard heard = one_second();
  EXPECT_NEAR(heard.encoders.back().left_wheel_rad, 1.0, 0.05);
  EXPECT_NEAR(heard.encoders.back().roll_rad, 0.5, 0.02);
  EXPECT_NEAR(heard.truths.back().path_length_m, 0.08, 0.005);
}

TEST(SimulatorNode, TwoRunsAreTheSame) {
  const Heard a = one_second(), b = one_second();
  EXPECT_EQ(a.encoders, b.encoders);
  EXPECT_EQ(a.truths, b.truths);
  ASSERT_EQ(a.scans.size(), b.scans.size());
  for (std::size_t i = 0; i < a.scans.size(); ++i) EXPECT_EQ(a.scans[i].ranges_m, b.scans[i].ranges_m);
}

}  // namespace
}  // namespace enfilade::simulator
