// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "tools/enfilade/verbs/options.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/evaluate/exploration/exploration_evaluation.hpp"
#include "tools/support/files.hpp"

namespace enfilade {
namespace {

struct ExplorationArguments {
  evaluate::ExplorationConfig config;
  std::vector<std::string> settings;
  std::string json;
};

int run(const ExplorationArguments& arguments) {
  evaluate::ExplorationConfig config = arguments.config;
  config.settings = Settings(arguments.settings);
  config.settings.refuse("simulator", "world", "--buildings");
  config.settings.refuse("simulator", "seed", "--seed");
  const auto tell = [](const evaluate::ExplorationRow& row) {
    std::cout << evaluate::to_line(row) << std::flush;
  };
  const auto rows = evaluate::evaluate_explorations(config, tell);
  if (config.only_write) return 0;
  if (!arguments.json.empty()) write_file(arguments.json, evaluate::to_json(rows));
  std::cout << evaluate::to_text(evaluate::sum_up(rows));
  return 0;
}

}  // namespace

Verb add_evaluate_exploration(CLI::App& group) {
  auto arguments = std::make_shared<ExplorationArguments>();
  CLI::App* command = group.add_subcommand("exploration", "Whole explorations of random furnished buildings");
  evaluate::ExplorationConfig& config = arguments->config;
  command->add_option("--buildings", config.buildings, "How many buildings")
      ->check(whole_number_in(1, 100000))
      ->capture_default_str();
  add_seed(*command, config.spec.seed, "Seed of the first building; the next has the next one")
      ->capture_default_str();
  command->add_option("--walkers", config.spec.walkers, "Probability that somebody walks in a room")
      ->check(number_in(0.0, 1.0))
      ->capture_default_str();
  command->add_option("--blocked", config.spec.blocked_doors, "Probability that something stands in a door")
      ->check(number_in(0.0, 1.0))
      ->capture_default_str();
  add_output_folder(*command, "--worlds", config.worlds, "Keep the world files in this folder");
  command->add_flag("--only-write", config.only_write, "Write the world files, explore nothing");
  add_settings(*command, arguments->settings);
  add_output_file(*command, "--json", arguments->json, "Write the figures to this file");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace enfilade
