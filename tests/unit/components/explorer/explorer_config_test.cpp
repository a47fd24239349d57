// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/node/explorer_config.hpp"

#include <gtest/gtest.h>

#include "components/explorer/node/explorer_node.hpp"
#include "tests/support/etc_folder.hpp"

namespace enfilade::explorer {
namespace {

TEST(ExplorerConfig, TheShippedFileHoldsTheDefaults) {
  std::string shipped, bare;
  load_config<ExplorerConfig>(enfilade::test::etc_folder() + "explorer.yaml", {}, &shipped);
  load_config<ExplorerConfig>("/dev/null", {}, &bare);
  EXPECT_EQ(shipped, bare);
}

TEST(ExplorerConfig, SenselessSettingsAreRefused) {
  MachineConfig config;
  config.exploration.max_sweeps_per_zone = 1;
  EXPECT_THROW(ExplorationMachine{config}, std::invalid_argument);
  config = {};
  config.drive.planner.soft_radius_m = 0.1;
  EXPECT_THROW(ExplorationMachine{config}, std::invalid_argument);
  config = {};
  config.drive.planner.narrow_radius_m = 0.23;  // there the guard would stop it
  EXPECT_THROW(ExplorationMachine{config}, std::invalid_argument);
}

}  // namespace
}  // namespace enfilade::explorer
