// SPDX-License-Identifier: Apache-2.0
#include <ctime>
#include <iostream>
#include <memory>

#include "tools/enfilade/report/report.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/evaluate/perception/evaluation.hpp"

namespace enfilade {
namespace {

struct Arguments {
  evaluate::PerceptionConfig config;
  std::string json, markdown;
};

std::string today() {
  const std::time_t now = std::time(nullptr);
  char text[16] = {};
  std::strftime(text, sizeof text, "%Y-%m-%d", std::gmtime(&now));
  return text;
}

int run(const Arguments& arguments) {
  const evaluate::PerceptionReport result = evaluate::evaluate_perception(arguments.config);
  if (!arguments.json.empty()) report::write_file(arguments.json, evaluate::to_json(result));
  if (!arguments.markdown.empty())
    report::write_file(arguments.markdown, evaluate::to_markdown(result, today()));
  std::cout << evaluate::to_table(result);
  return 0;
}

}  // namespace

Verb add_evaluate_perception(CLI::App& group) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = group.add_subcommand(
      "perception", "Rooms and doors found in random furnished rooms by the paper's score and by ours");
  command->add_option("--rooms", arguments->config.rooms, "How many rooms")->check(CLI::Range(1, 100000));
  command->add_option("--seed", arguments->config.seed, "Seed of rooms and noise");
  command->add_option("--json", arguments->json, "Write the figures to this file");
  command->add_option("--markdown", arguments->markdown, "Write a report to this file");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace enfilade
