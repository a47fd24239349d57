// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/node/grid_builder_config.hpp"

#include <gtest/gtest.h>

#include "tests/support/etc_folder.hpp"

namespace enfilade::grid_builder {
namespace {

TEST(GridBuilderConfig, IsShippedWithItsDefaults) {
  const std::string file = enfilade::test::etc_folder() + "gridBuilder.yaml";
  GridBuilderConfig config;
  EXPECT_NO_THROW(ZoneGrid{config.grid});
  const auto loaded = load_config<GridBuilderConfig>(file);
  EXPECT_EQ(loaded.grid.resolution_m, config.grid.resolution_m);
  EXPECT_EQ(loaded.grid.max_memory_mb, config.grid.max_memory_mb);
  EXPECT_EQ(loaded.odometry.max_samples, config.odometry.max_samples);
  EXPECT_EQ(loaded.gate.only_during_sweeps, config.gate.only_during_sweeps);
}

TEST(GridBuilderConfig, TakesOverridesByGroup) {
  const std::string file = enfilade::test::etc_folder() + "gridBuilder.yaml";
  const auto loaded = load_config<GridBuilderConfig>(file, {"grid.resolution_m=0.1", "stationary=true"});
  EXPECT_EQ(loaded.grid.resolution_m, 0.1);
  EXPECT_TRUE(loaded.gate.stationary);
  EXPECT_THROW(load_config<GridBuilderConfig>(file, {"grid.prob_hit=1.5"}), ConfigError);
}

}  // namespace
}  // namespace enfilade::grid_builder
