// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <thread>

#include <unistd.h>

#include "interfaces/runtime/command_line.hpp"
#include "tools/enfilade/report/report.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/evaluate/latency/latency_report.hpp"
#include "tools/evaluate/latency/latency_run.hpp"

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
  for (const char* const transport : {"shared_memory", "udp"}) {
    if (arguments.transport != "both" && arguments.transport != transport) continue;
    config.shared_memory = std::string(transport) == "shared_memory";
    report.parts.push_back({transport, evaluate::latency_figures(evaluate::record_latency(config))});
  }
  getloadavg(&report.load, 1);
  if (!arguments.json.empty()) report::write_file(arguments.json, evaluate::to_json(report));
  std::cout << evaluate::to_table(report);
  return 0;
}

}  // namespace

Verb add_evaluate_latency(CLI::App& group) {
  auto arguments = std::make_shared<LatencyArguments>();
  CLI::App* command = group.add_subcommand(
      "latency", "Wall time from the joint sample that completes a scan line to the room estimate, over DDS");
  command->add_option("--seconds", arguments->config.seconds, "How long to measure over each transport")
      ->check(CLI::Range(1.0, 300.0));
  command->add_option("--world", arguments->config.world, "World file; the paper's two rooms by default");
  command->add_option("--step", arguments->config.step_deg, "Degrees between two lines")
      ->check(CLI::Range(0.05, 10.0));
  command->add_option("--transport", arguments->transport, "shared_memory, udp or both")
      ->check(CLI::IsMember({"shared_memory", "udp", "both"}));
  command->add_option("--domain", arguments->config.domain, "DDS domain; one that is hardly used by default")
      ->check(CLI::Range(1, 232));
  command->add_option("--json", arguments->json, "Write the figures to this file");
  command
      ->add_option("--set", arguments->settings,
                   "COMPONENT.KEY=VALUE: override one configuration key; may be repeated")
      ->allow_extra_args(false);
  return {command, [arguments] { return measure_latency(*arguments); }};
}

}  // namespace enfilade
