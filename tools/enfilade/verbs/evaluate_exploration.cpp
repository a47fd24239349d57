// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "tools/enfilade/report/report.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/evaluate/exploration/exploration_evaluation.hpp"

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
  const auto tell = [](const evaluate::ExplorationRow& row) {
    std::cout << evaluate::to_line(row) << std::flush;
  };
  const auto rows = evaluate::evaluate_explorations(config, tell);
  if (config.only_write) return 0;
  if (!arguments.json.empty()) report::write_file(arguments.json, evaluate::to_json(rows));
  std::cout << evaluate::to_text(evaluate::sum_up(rows));
  return 0;
}

}  // namespace

Verb add_evaluate_exploration(CLI::App& group) {
  auto arguments = std::make_shared<ExplorationArguments>();
  CLI::App* command = group.add_subcommand("exploration", "Whole explorations of random furnished buildings");
  evaluate::ExplorationConfig& config = arguments->config;
  command->add_option("--buildings", config.buildings, "How many buildings")->check(CLI::Range(1, 100000));
  command->add_option("--seed", config.spec.seed, "Seed of the first building; the next has the next one");
  command->add_option("--walkers", config.spec.walkers, "Probability that somebody walks in a room")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--blocked", config.spec.blocked_doors, "Probability that something stands in a door")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--worlds", config.worlds, "Keep the world files in this folder");
  command->add_flag("--only-write", config.only_write, "Write the world files, explore nothing");
  command
      ->add_option("--set", arguments->settings,
                   "COMPONENT.KEY=VALUE: override one configuration key; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--json", arguments->json, "Write the figures to this file");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace enfilade
