// SPDX-License-Identifier: Apache-2.0
// Whole processes from command line to exit status, on an in-process bus.
#include "interfaces/runtime/process.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "interfaces/bus/in_process_bus.hpp"
#include "tests/support/fake_node.hpp"

namespace enfilade {
namespace {

struct ProcessConfig {
  PeriodConfig period;
};
void bind(ConfigBinder& c, ProcessConfig& config) {
  c.group("period", [&](ConfigBinder& g) { bind(g, config.period); });
}

int run_fake(FakeNode::Calls calls, std::vector<const char*> arguments) {
  ProcessConfig config;
  const ComponentRecipe recipe{.name = "explorer",
                               .load =
                                   [&config](const std::string& file, const ConfigOverrides& overrides) {
                                     std::string resolved;
                                     config = load_config<ProcessConfig>(file, overrides, &resolved);
                                     return resolved;
                                   },
                               .period = [&config] { return config.period; },
                               .make_node = FakeNode::make(std::move(calls))};
  static InProcessNetwork network;
  arguments.insert(arguments.begin(), "explorer");
  return run_process(recipe, static_cast<int>(arguments.size()), arguments.data(),
                     [](const std::string& component, int, Executor& executor, Log&) {
                       return std::make_unique<InProcessBus>(
                           network, component, 0,
                           [&executor](int, std::function<void()> work) { executor.post(std::move(work)); });
                     });
}

struct ProcessTest : testing::Test {
  void SetUp() override {
    std::filesystem::create_directories(folder);
    std::ofstream(folder + "/explorer.yaml") << "period: {compute_s: 0.01}\n";
  }
  void TearDown() override {
    if (child > 0) {
      kill(child, SIGKILL);
      waitpid(child, nullptr, 0);
    }
    std::filesystem::remove_all(folder);
  }

  pid_t start(const FakeNode::Calls& calls, const std::vector<const char*>& arguments = {}) {
    const pid_t pid = fork();
    if (pid != 0) return pid;
    setenv("XDG_RUNTIME_DIR", folder.c_str(), 1);
    setenv("ENFILADE_ETC", folder.c_str(), 1);
    dup2(open((folder + "/stderr").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600), STDERR_FILENO);
    _exit(run_fake(calls, arguments));
  }

  static int wait_for_exit(pid_t pid) {
    int status = 0;
    waitpid(pid, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  int run(const FakeNode::Calls& calls, const std::vector<const char*>& arguments = {}) {
    return wait_for_exit(start(calls, arguments));
  }

  bool wait_for_line(const std::string& text) const {
    for (int i = 0; i < 1000; ++i) {
      if (said().find(text) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
  std::string said() const {
    std::ostringstream text;
    text << std::ifstream(folder + "/stderr").rdbuf();
    return text.str();
  }

  std::string folder = testing::TempDir() + "enfilade_process_" + std::to_string(getpid());
  pid_t child = 0;
};

FakeNode::Call say(const char* text) {
  return [text](const NodeContext& context) { context.log.info(text); };
}

TEST_F(ProcessTest, StopsInGoodOrderOnEitherSignal) {
  for (const int signal_number : {SIGINT, SIGTERM}) {
    child = start({.shutdown = say("good night")});
    ASSERT_TRUE(wait_for_line("running"));
    const auto begin = std::chrono::steady_clock::now();
    kill(child, signal_number);
    EXPECT_EQ(wait_for_exit(std::exchange(child, 0)), 0);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
    EXPECT_NE(said().find("good night"), std::string::npos);
    std::filesystem::remove(folder + "/stderr");
  }
}

TEST_F(ProcessTest, AHungNodeIsEndedWithinTwoSecondsAndStatusOne) {
  child = start({.compute = [](const NodeContext& context) {
    context.log.info("hanging");
    std::this_thread::sleep_for(std::chrono::seconds(60));
  }});
  ASSERT_TRUE(wait_for_line("hanging"));
  const auto begin = std::chrono::steady_clock::now();
  kill(child, SIGTERM);
  EXPECT_EQ(wait_for_exit(std::exchange(child, 0)), 1);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
  EXPECT_NE(said().find("does not stop"), std::string::npos);
}

TEST_F(ProcessTest, AnExceptionInInitializeEndsItWithStatusTwoAndItsSentence) {
  EXPECT_EQ(
      run({.initialize = [](const NodeContext&) { throw std::runtime_error("no laser on /dev/ttyACM0"); }}),
      2);
  EXPECT_NE(said().find("no laser on /dev/ttyACM0"), std::string::npos);
}

TEST_F(ProcessTest, AWrongConfigurationIsStatusTwoAndOneLineForEachProblem) {
  EXPECT_EQ(run({}, {"--set", "period.compute=1", "--set", "period.emergency_s=0"}), 2);
  EXPECT_EQ(said(),
            "explorer: --set period.emergency_s: 0 is out of range, write a number from 0.01 to 60\n"
            "explorer: --set period.compute: there is no such key, did you mean period.compute_s?\n");
}

TEST_F(ProcessTest, ASecondInstanceInTheDomainEndsWithStatusOneAndNamesTheFirst) {
  child = start({}, {"--domain", "5"});
  ASSERT_TRUE(wait_for_line("running"));
  EXPECT_EQ(run({}, {"--domain", "5"}), 1);
  EXPECT_NE(said().find("explorer: process " + std::to_string(child) + " already runs explorer in domain 5"),
            std::string::npos)
      << said();
}

TEST_F(ProcessTest, WaitsForTheSimulatorsTimeAndStillStops) {
  child = start({.initialize = say("initialized")}, {"--sim-time"});
  ASSERT_TRUE(wait_for_line("waiting for the time of the simulator"));
  kill(child, SIGINT);
  EXPECT_EQ(wait_for_exit(std::exchange(child, 0)), 0);
  EXPECT_EQ(said().find("initialized"), std::string::npos);
}

}  // namespace
}  // namespace enfilade
