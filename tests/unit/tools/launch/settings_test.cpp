// SPDX-License-Identifier: Apache-2.0
#include "tools/launch/settings.hpp"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

TEST(Settings, SplitsComponentFromKeyAtTheFirstDot) {
  const Settings settings({"roomDetector.step_m=0.27", "gridBuilder.period.compute_s=0.2"});
  EXPECT_EQ(settings.of("roomDetector"), ConfigOverrides{"step_m=0.27"});
  EXPECT_EQ(settings.of("gridBuilder"), ConfigOverrides{"period.compute_s=0.2"});
  EXPECT_TRUE(settings.of("explorer").empty());
}

TEST(Settings, KeepsWhatWasSetFromDefaults) {
  Settings settings({"roomDetector.step_m=0.27"});
  settings.set_default("roomDetector", "step_m", "0.1");
  settings.set_default("roomDetector", "step", "1");
  EXPECT_EQ(settings.of("roomDetector"), (ConfigOverrides{"step_m=0.27", "step=1"}));
}

TEST(Settings, RefusesWhatTheCommandTellsAndNothingElse) {
  const Settings settings({"simulator.world=a.yaml", "simulator.world_seed=1"});
  EXPECT_NO_THROW(settings.refuse("simulator", "seed", "--seed"));
  EXPECT_NO_THROW(settings.refuse("laser3D", "world", "--world"));
  try {
    settings.refuse("simulator", "world", "--world");
    FAIL() << "accepted";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "--set simulator.world=a.yaml: leave it out, --world tells this here");
  }
}

TEST(Settings, RefusesUnknownComponentNamingTheKnownOnes) {
  try {
    Settings({"roomdetector.step_m=0.27"});
    FAIL() << "accepted";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("roomDetector"), std::string::npos);
  }
  EXPECT_THROW(Settings({"step_m=0.27"}), ConfigError);
  EXPECT_THROW(Settings({"roomDetector.step_m"}), ConfigError);
}

}  // namespace
}  // namespace enfilade
