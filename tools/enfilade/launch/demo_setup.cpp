// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "interfaces/runtime/command_line.hpp"
#include "tools/enfilade/launch/demo.hpp"

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

}  // namespace

std::string prepare_out_folder(const DemoOptions& options) {
  const std::time_t now = std::time(nullptr);
  const std::string folder =
      options.out.empty() ? fmt::format("out/{:%Y-%m-%dT%H-%M-%S}", fmt::localtime(now)) : options.out;
  std::error_code error;
  std::filesystem::create_directories(folder + "/log", error);
  if (error)
    throw std::runtime_error(
        fmt::format("{}: cannot be made ({}): choose another --out", folder, error.message()));
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
    if (last.find("error") != std::string::npos) std::cerr << last << "\n";
  }
}

}  // namespace enfilade::launch
