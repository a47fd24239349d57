// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>

#include "tools/enfilade/report/report.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/evaluate/perception/evaluation.hpp"

namespace enfilade {
namespace {

struct PerceptionArguments {
  evaluate::PerceptionConfig config;
  std::string json, markdown;
};

int run(const PerceptionArguments& arguments) {
  const evaluate::PerceptionReport result = evaluate::evaluate_perception(arguments.config);
  if (!arguments.json.empty()) report::write_file(arguments.json, evaluate::to_json(result));
  if (!arguments.markdown.empty())
    report::write_file(arguments.markdown, evaluate::to_markdown(result, report::today()));
  std::cout << evaluate::to_table(result);
  return 0;
}

}  // namespace

Verb add_evaluate_perception(CLI::App& group) {
  auto arguments = std::make_shared<PerceptionArguments>();
  CLI::App* command = group.add_subcommand(
      "perception", "Rooms and doors found in random furnished rooms by the paper's score and by ours");
  command->add_option("--rooms", arguments->config.rooms, "How many rooms")->check(CLI::Range(1, 100000));
  command->add_option("--seed", arguments->config.seed, "Seed of rooms and noise");
  command->add_option("--json", arguments->json, "Write the figures to this file");
  command->add_option("--markdown", arguments->markdown, "Write a report to this file");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace enfilade
