// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "interfaces/runtime/command_line.hpp"
#include "tools/launch/demo.hpp"
#include "tools/support/files.hpp"

namespace enfilade::launch {
namespace {

/// Losing the world cannot be mended by starting another one.
bool can_restart(const std::string& component) { return component != "simulator"; }

std::string last_line(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line, last;
  while (std::getline(stream, line)) {
    if (!line.empty()) last = line;
  }
  return last;
}

/// What an earlier run has left in its --out: it must be neither resumed nor mixed with this run's.
void remove_earlier_run(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    const bool is_ours = name.starts_with("map.yaml") || name == "report.json" || name == "floorplan.svg" ||
                         (name.starts_with("room") && name.ends_with(".svg"));
    if (is_ours) std::filesystem::remove(entry.path(), ignored);
  }
  for (const std::string_view component : kComponents)
    std::filesystem::remove(folder / "log" / fmt::format("{}.log", component), ignored);
}

}  // namespace

std::string prepare_out_folder(const DemoOptions& options) {
  const std::time_t now = std::time(nullptr);
  const std::string folder =
      options.out.empty() ? fmt::format("out/{:%Y-%m-%dT%H-%M-%S}", fmt::localtime(now)) : options.out;
  make_folder(folder + "/log");
  remove_earlier_run(folder);
  return std::filesystem::absolute(folder).string();
}

DeploymentConfig deployment_of(const std::vector<std::string>& components, const Settings& settings,
                               int domain, bool sim_time, const std::string& out_folder) {
  DeploymentConfig config{.bin_folder = std::filesystem::path(executable_path()).parent_path().string(),
                          .log_folder = out_folder + "/log"};
  for (const std::string& component : components) {
    Member member{.component = component,
                  .arguments = {"--domain", std::to_string(domain)},
                  .restart = can_restart(component)};
    if (sim_time && component != "simulator") member.arguments.push_back("--sim-time");
    for (const std::string& setting : settings.of(component)) {
      member.arguments.push_back("--set");
      member.arguments.push_back(setting);
    }
    config.members.push_back(std::move(member));
  }
  return config;
}

void print_loss(const std::string& out_folder) {
  for (const std::string_view component : kComponents) {
    const std::string last = last_line(fmt::format("{}/log/{}.log", out_folder, component));
    const bool refused = last.starts_with(std::string(component) + ": ");
    if (refused || last.find("error") != std::string::npos) std::cerr << last << "\n";
  }
}

}  // namespace enfilade::launch
