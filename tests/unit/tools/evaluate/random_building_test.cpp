// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/exploration/random_building.hpp"

#include <gtest/gtest.h>

#include "tests/unit/tools/simulator/temporary_file.hpp"
#include "tools/simulator/core/simulation.hpp"
#include "tools/simulator/world/load_world.hpp"

namespace enfilade::evaluate {
namespace {

/// Rooms that can be reached from the one in which the robot starts.
std::size_t reachable(const RandomBuilding& building) {
  std::vector<bool> reached(building.rooms.size(), false);
  reached[building.start_room] = true;
  for (std::size_t round = 0; round < building.rooms.size(); ++round)
    for (const BuiltDoor& door : building.doors)
      if (door.to && reached[door.opening.room] != reached[*door.to])
        reached[door.opening.room] = reached[*door.to] = true;
  return static_cast<std::size_t>(std::count(reached.begin(), reached.end(), true));
}

TEST(RandomBuilding, IsAWorldThatTheSimulatorBuildsAndTheRobotFitsInto) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const RandomBuilding building = random_building({.seed = seed, .walkers = 0.5, .blocked_doors = 0.5});
    const simulator::test::TemporaryFile file("world.yaml", world_yaml(building));
    simulator::World world;
    ASSERT_NO_THROW(world = simulator::load_world(file.path())) << seed;
    EXPECT_NO_THROW(simulator::Simulation(world, simulator::SimulationConfig{})) << seed;
    EXPECT_EQ(world.truth.rooms.size(), building.rooms.size());
    EXPECT_EQ(reachable(building), building.rooms.size()) << seed;
  }
}

TEST(RandomBuilding, IsTheSameForTheSameSeed) {
  EXPECT_EQ(world_yaml(random_building({.seed = 7})), world_yaml(random_building({.seed = 7})));
  EXPECT_NE(world_yaml(random_building({.seed = 7})), world_yaml(random_building({.seed = 8})));
}

}  // namespace
}  // namespace enfilade::evaluate
