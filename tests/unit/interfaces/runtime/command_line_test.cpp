// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/command_line.hpp"

#include <filesystem>
#include <fstream>
#include <map>

#include <gtest/gtest.h>
#include <unistd.h>

namespace enfilade {
namespace {

Environment environment(std::map<std::string, std::string> values) {
  return [values = std::move(values)](const char* name) {
    const auto found = values.find(name);
    return found == values.end() ? std::nullopt : std::optional<std::string>(found->second);
  };
}

ParsedCommandLine parse(std::vector<const char*> arguments) {
  arguments.insert(arguments.begin(), "explorer");
  return parse_command_line("explorer", static_cast<int>(arguments.size()), arguments.data());
}

TEST(CommandLine, TakesEveryOption) {
  const auto parsed = parse({"--config", "x.yaml", "--set", "a=1", "--set", "b=2", "--domain", "7",
                             "--sim-time", "--log-level", "debug"});
  ASSERT_TRUE(parsed.command_line);
  EXPECT_EQ(parsed.command_line->config_file, "x.yaml");
  EXPECT_EQ(parsed.command_line->overrides, (ConfigOverrides{"a=1", "b=2"}));
  EXPECT_EQ(parsed.command_line->domain, 7);
  EXPECT_TRUE(parsed.command_line->sim_time);
  EXPECT_EQ(parsed.command_line->log_level, "debug");
}

TEST(CommandLine, DefaultsAreWallTimeAndNoDomain) {
  const auto parsed = parse({});
  ASSERT_TRUE(parsed.command_line);
  EXPECT_FALSE(parsed.command_line->sim_time);
  EXPECT_EQ(parsed.command_line->domain, std::nullopt);
}

TEST(CommandLine, MistakesGiveStatusTwoAndHelpGivesZero) {
  EXPECT_EQ(parse({"--domain", "233"}).exit_status, 2);
  EXPECT_EQ(parse({"--no-such"}).exit_status, 2);
  EXPECT_EQ(parse({"--set", "a=1", "stray"}).exit_status, 2);
  EXPECT_EQ(parse({"--log-level", "loud"}).exit_status, 2);
  EXPECT_FALSE(parse({"--help"}).command_line);
  EXPECT_EQ(parse({"--help"}).exit_status, 0);
}

TEST(Domain, CommandLineBeforeOurVariableBeforeThatOfRos) {
  const auto both = environment({{"ENFILADE_DOMAIN", "5"}, {"ROS_DOMAIN_ID", "6"}});
  EXPECT_EQ(resolve_domain(4, both), 4);
  EXPECT_EQ(resolve_domain({}, both), 5);
  EXPECT_EQ(resolve_domain({}, environment({{"ROS_DOMAIN_ID", "6"}})), 6);
  EXPECT_EQ(resolve_domain({}, environment({})), 0);
}

TEST(Domain, AVariableOutOfRangeIsNamed) {
  try {
    resolve_domain({}, environment({{"ROS_DOMAIN_ID", "233"}}));
    FAIL();
  } catch (const ConfigError& e) {
    EXPECT_STREQ(e.what(), "ROS_DOMAIN_ID: 233 is out of range, write a whole number from 0 to 232");
  }
  EXPECT_THROW(resolve_domain({}, environment({{"ENFILADE_DOMAIN", "x"}})), ConfigError);
}

struct ConfigFileTest : testing::Test {
  void TearDown() override { std::filesystem::remove_all(root); }
  void touch(const std::string& file) const {
    std::filesystem::create_directories(std::filesystem::path(root + file).parent_path());
    std::ofstream(root + file) << "\n";
  }
  std::string root = testing::TempDir() + "enfilade_files_" + std::to_string(getpid());
};

TEST_F(ConfigFileTest, IsFoundInTheCheckoutAndInTheInstall) {
  touch("/checkout/etc/explorer.yaml");
  EXPECT_EQ(find_config_file("explorer", root + "/checkout/build/dev/bin/explorer", environment({})),
            root + "/checkout/etc/explorer.yaml");
  touch("/usr/share/enfilade/etc/explorer.yaml");
  EXPECT_EQ(find_config_file("explorer", root + "/usr/bin/explorer", environment({})),
            root + "/usr/share/enfilade/etc/explorer.yaml");
}

TEST_F(ConfigFileTest, TheVariableIsTheOnlyPlaceWhereItIsSet) {
  touch("/checkout/etc/explorer.yaml");
  const std::string executable = root + "/checkout/build/dev/bin/explorer";
  touch("/mine/explorer.yaml");
  EXPECT_EQ(find_config_file("explorer", executable, environment({{"ENFILADE_ETC", root + "/mine"}})),
            root + "/mine/explorer.yaml");
  EXPECT_THROW(find_config_file("explorer", executable, environment({{"ENFILADE_ETC", root + "/none"}})),
               ConfigError);
}

}  // namespace
}  // namespace enfilade
