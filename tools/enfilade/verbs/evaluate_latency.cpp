// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <thread>

#include <unistd.h>

#include "interfaces/runtime/command_line.hpp"
#include "tools/enfilade/verbs/options.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/evaluate/latency/latency_report.hpp"
#include "tools/evaluate/latency/latency_run.hpp"
#include "tools/launch/composed_run.hpp"
#include "tools/simulator/world/load_world.hpp"
#include "tools/support/files.hpp"

namespace enfilade {
namespace {

struct LatencyArguments {
  evaluate::LatencyRunConfig config;
  std::vector<std::string> settings;
  std::string transport = "both", json;
};

std::string shipped_world() {
  const std::filesystem::path etc = find_config_file("simulator", executable_path(), process_environment);
  return etc.parent_path() / "worlds/paper_two_rooms.yaml";
}

int measure_latency(const LatencyArguments& arguments) {
  evaluate::LatencyReport report{.processors = std::thread::hardware_concurrency()};
  evaluate::LatencyRunConfig config = arguments.config;
  if (config.world.empty()) config.world = shipped_world();
  if (config.domain == 0) config.domain = 100 + getpid() % 100;  // hardly anybody else's
  config.settings = Settings(arguments.settings);
  check_settings(config.settings);
  config.settings.refuse("simulator", "world", "--world");
  simulator::load_world(config.world);  // throws here rather than in a process
  for (const char* const transport : {"shared_memory", "udp"}) {
    if (arguments.transport != "both" && arguments.transport != transport) continue;
    config.shared_memory = std::string(transport) == "shared_memory";
    report.parts.push_back({transport, evaluate::latency_figures(evaluate::record_latency(config))});
  }
  getloadavg(&report.load, 1);
  if (!arguments.json.empty()) write_file(arguments.json, evaluate::to_json(report));
  std::cout << evaluate::to_table(report);
  return 0;
}

}  // namespace

Verb add_evaluate_latency(CLI::App& group) {
  auto arguments = std::make_shared<LatencyArguments>();
  CLI::App* command = group.add_subcommand(
      "latency", "Wall time from the joint sample that completes a scan line to the room estimate, over DDS");
  command->add_option("--seconds", arguments->config.seconds, "How long to measure over each transport")
      ->check(number_in(1.0, 300.0))
      ->capture_default_str();
  command->add_option("--world", arguments->config.world, "World file; the paper's two rooms by default");
  command->add_option("--step", arguments->config.step_deg, "Degrees between two lines")
      ->check(number_in(0.05, 10.0))
      ->capture_default_str();
  command->add_option("--transport", arguments->transport, "shared_memory, udp or both")
      ->check(CLI::IsMember({"shared_memory", "udp", "both"}))
      ->capture_default_str();
  command->add_option("--domain", arguments->config.domain, "DDS domain; one that is hardly used by default")
      ->check(whole_number_in(1, 232));
  add_output_file(*command, "--json", arguments->json, "Write the figures to this file");
  add_settings(*command, arguments->settings);
  return {command, [arguments] { return measure_latency(*arguments); }};
}

}  // namespace enfilade
