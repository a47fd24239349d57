// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/config.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "interfaces/runtime/nearest.hpp"

namespace enfilade {
namespace {

enum class Door { kPaper, kBand };

struct SampleConfig {
  PeriodConfig period;
  double step_m = 0.05;
  int votes = 8;
  bool sweep = true;
  std::string frame = "odom";
  Door door = Door::kBand;
};

void bind(ConfigBinder& c, SampleConfig& config) {
  c.group("period", [&](ConfigBinder& g) { bind(g, config.period); });
  c.number("step_m", config.step_m, 0.01, 1.0);
  c.integer("votes", config.votes, 1, 100);
  c.flag("sweep", config.sweep);
  c.text("frame", config.frame);
  c.choice("doors", config.door, {{"paper", Door::kPaper}, {"band", Door::kBand}});
}

struct ConfigTest : testing::Test {
  void SetUp() override { std::filesystem::create_directories(folder); }
  void TearDown() override { std::filesystem::remove_all(folder); }

  SampleConfig load(const std::string& text, const ConfigOverrides& overrides = {},
                    const std::string& prefix = "") {
    std::ofstream(file) << text;
    return load_config<SampleConfig>(file, overrides, &resolved, prefix);
  }

  /// The lines of the error, "FILE" standing for the file's path.
  std::string problems(const std::string& text, const ConfigOverrides& overrides = {},
                       const std::string& prefix = "") {
    try {
      load(text, overrides, prefix);
    } catch (const ConfigError& e) {
      std::string what = e.what();
      for (std::size_t at; (at = what.find(file)) != std::string::npos;)
        what.replace(at, file.size(), "FILE");
      return what;
    }
    return "none";
  }

  std::string folder = testing::TempDir() + "enfilade_config_" + std::to_string(getpid());
  std::string file = folder + "/x.yaml";
  std::string resolved;
};

TEST_F(ConfigTest, AbsentKeysKeepTheirDefaults) {
  for (const char* text : {"", "# nothing\n", "period:\n", "{}\n"}) {
    const SampleConfig config = load(text);
    EXPECT_EQ(config.step_m, 0.05) << text;
    EXPECT_EQ(config.period.compute_s, 0.1) << text;
    EXPECT_EQ(config.door, Door::kBand) << text;
  }
}

TEST_F(ConfigTest, GivenKeysAreTaken) {
  const SampleConfig config = load(
      "period: {compute_s: 0.5}\nstep_m: +2.7e-1\nvotes: 9\nsweep: false\nframe: \"a: b\"\ndoors: paper\n");
  EXPECT_EQ(config.period.compute_s, 0.5);
  EXPECT_EQ(config.step_m, 0.27);
  EXPECT_EQ(config.votes, 9);
  EXPECT_FALSE(config.sweep);
  EXPECT_EQ(config.frame, "a: b");
  EXPECT_EQ(config.door, Door::kPaper);
}

TEST_F(ConfigTest, EveryProblemIsReportedAtOnceEachWithItsLine) {
  EXPECT_EQ(problems("step_m: 0.5\n"
                     "vots: 9\n"
                     "sweep: yes\n"
                     "step_m: 0.6\n"
                     "period:\n"
                     "  compute_s: 20\n"
                     "doors: none\n"),
            "FILE:2: vots: there is no such key, did you mean votes?\n"
            "FILE:3: sweep: 'yes' is neither true nor false, write one of these\n"
            "FILE:4: step_m: is given twice, first in line 1, keep one of them\n"
            "FILE:6: period.compute_s: 20 is out of range, write a number from 0.001 to 10\n"
            "FILE:7: doors: 'none' is unknown, write one of: paper, band");
}

TEST_F(ConfigTest, ADuplicateInsideAGroupIsFound) {
  EXPECT_EQ(problems("period:\n  compute_s: 1\n  compute_s: 1\n"),
            "FILE:3: period.compute_s: is given twice, first in line 2, keep one of them");
}

TEST_F(ConfigTest, NumbersAreWholeFiniteAndInRange) {
  const std::string advice = ", write a number from 0.01 to 1";
  EXPECT_EQ(problems("step_m: 0.5x\n"), "FILE:1: step_m: '0.5x' is not a number" + advice);
  EXPECT_EQ(problems("step_m: nan\n"), "FILE:1: step_m: 'nan' is not finite" + advice);
  EXPECT_EQ(problems("step_m: .inf\n"), "FILE:1: step_m: 'inf' is not finite" + advice);
  EXPECT_EQ(problems("step_m: 1e999\n"), "FILE:1: step_m: 1e999 is out of range" + advice);
  EXPECT_EQ(problems("step_m: 1,5\n"), "FILE:1: step_m: '1,5' is not a number" + advice);
  EXPECT_EQ(problems("votes: 3.0\n"),
            "FILE:1: votes: '3.0' is not a whole number, write a whole number from 1 to 100");
  EXPECT_EQ(problems("votes: 99999999999\n"),
            "FILE:1: votes: 99999999999 is out of range, write a whole number from 1 to 100");
  EXPECT_EQ(problems("step_m: 1.0\nvotes: 100\n"), "none");
}

TEST_F(ConfigTest, ValuesOfTheWrongShapeAreRefused) {
  EXPECT_EQ(problems("step_m: \"0.5\"\n"), "FILE:1: step_m: \"0.5\" is text, take the quotes away");
  EXPECT_EQ(problems("step_m:\n"), "FILE:1: step_m: has no value, write one or remove the line");
  EXPECT_EQ(problems("step_m: [0.5]\n"), "FILE:1: step_m: is a list or map, write a single value");
  EXPECT_EQ(problems("period: 3\n"), "FILE:1: period: is a group of keys, write them indented below it");
  EXPECT_EQ(problems("? [a, b]\n: 3\n"), "FILE:1: ?: a list or map stands for a key, write a name");
}

TEST_F(ConfigTest, FilesThatAreNoMapAreOneSentence) {
  EXPECT_EQ(problems("- 1\n- 2\n"), "FILE:1: the file is not a map, write lines of the form \"key: value\"");
  EXPECT_EQ(problems("step_m: 0.5\n---\nstep_m: 0.6\n"),
            "FILE:1: there are several YAML documents in the file, keep one");
  const std::string broken = problems("step_m: 0.5\nvotes: [1,\n");
  EXPECT_TRUE(broken.starts_with("FILE:3: this is not YAML (")) << broken;
  EXPECT_EQ(broken.find('\n'), std::string::npos);
}

TEST_F(ConfigTest, AFileThatCannotBeReadIsNamed) {
  for (const std::string& name : {folder + "/none.yaml", folder}) {
    try {
      load_config<SampleConfig>(name);
      FAIL() << name;
    } catch (const ConfigError& e) {
      EXPECT_TRUE(std::string(e.what()).starts_with(name + ": ")) << e.what();
    }
  }
}

TEST_F(ConfigTest, OverridesWinAndTheLastOfThemCounts) {
  const SampleConfig config =
      load("step_m: 0.5\n", {"step_m=0.2", "period.compute_s=2", "frame=a=b", "step_m=0.3"});
  EXPECT_EQ(config.step_m, 0.3);
  EXPECT_EQ(config.period.compute_s, 2.0);
  EXPECT_EQ(config.frame, "a=b");
}

TEST_F(ConfigTest, OverridesAreCheckedLikeTheFile) {
  EXPECT_EQ(problems("votes: 0\n", {"step_m=7", "compute_s=1", "period=1", "sweep"}),
            "FILE:1: votes: 0 is out of range, write a whole number from 1 to 100\n"
            "--set sweep: this is no setting, write KEY=VALUE\n"
            "--set period: is a group of keys, set one of these\n"
            "--set step_m: 7 is out of range, write a number from 0.01 to 1\n"
            "--set compute_s: there is no such key, did you mean period.compute_s?");
}

TEST_F(ConfigTest, OverridesAreNamedAsTheyWereGiven) {
  EXPECT_EQ(problems("", {"vots=1", "step_m=7", "nope=1"}, "explorer."),
            "--set explorer.step_m: 7 is out of range, write a number from 0.01 to 1\n"
            "--set explorer.nope: there is no such key, choose one of those in FILE\n"
            "--set explorer.vots: there is no such key, did you mean explorer.votes?");
}

TEST_F(ConfigTest, TheResolvedTextHoldsEveryKeyAndReadsBackTheSame) {
  load("step_m: 0.27\nframe: \"true\"\n", {"doors=paper"});
  EXPECT_EQ(resolved,
            "period:\n  compute_s: 0.1\n  emergency_s: 0.5\nstep_m: 0.27\nvotes: 8\nsweep: true\n"
            "frame: \"true\"\ndoors: paper\n");
  const std::string once = resolved;
  load(once);
  EXPECT_EQ(resolved, once);
}

TEST(Nearest, CountsEditsAndGivesUpWhenTheyAreMany) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(find_nearest("width", {"height_m", "width_m"}), "width_m");
  EXPECT_EQ(find_nearest("colour", {"height_m", "width_m"}), std::nullopt);
}

}  // namespace
}  // namespace enfilade
