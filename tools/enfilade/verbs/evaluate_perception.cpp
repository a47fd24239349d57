// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "tools/enfilade/verbs/options.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/evaluate/perception/evaluation.hpp"

namespace enfilade {
namespace {

struct PerceptionArguments {
  evaluate::PerceptionConfig config;
  ReportFiles files;
};

int run(const PerceptionArguments& arguments) {
  const evaluate::PerceptionReport result = evaluate::evaluate_perception(arguments.config);
  write(arguments.files, evaluate::to_json(result), evaluate::to_markdown(result, today()));
  std::cout << evaluate::to_table(result);
  return 0;
}

}  // namespace

Verb add_evaluate_perception(CLI::App& group) {
  auto arguments = std::make_shared<PerceptionArguments>();
  CLI::App* command = group.add_subcommand(
      "perception", "Rooms and doors found in random furnished rooms by the paper's score and by ours");
  command->add_option("--rooms", arguments->config.rooms, "How many rooms")
      ->check(whole_number_in(1, 100000))
      ->capture_default_str();
  add_seed(*command, arguments->config.seed, "Seed of rooms and noise")->capture_default_str();
  add_report_files(*command, arguments->files);
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace enfilade
