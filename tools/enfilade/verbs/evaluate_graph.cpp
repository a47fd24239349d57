// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>
#include <memory>

#include "components/topoGraph/node/topo_graph_config.hpp"
#include "interfaces/runtime/command_line.hpp"
#include "tools/enfilade/verbs/options.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/evaluate/graph/graph_evaluation.hpp"

namespace enfilade {
namespace {

struct GraphArguments {
  evaluate::GraphEvaluationConfig config;
  ReportFiles files;
  bool without_ring = false;
};

int run(const GraphArguments& arguments) {
  const std::string file = find_config_file("topoGraph", executable_path(), process_environment);
  evaluate::GraphEvaluationConfig config = arguments.config;
  config.graph = load_config<topo_graph::TopoGraphConfig>(file, {}).graph;
  if (!arguments.without_ring)
    config.ring_world = std::filesystem::path(file).parent_path() / "worlds" / "four_rooms_ring.yaml";
  const evaluate::GraphReport result = evaluate::evaluate_graph(config);
  write(arguments.files, evaluate::to_json(result), evaluate::to_markdown(result, today()));
  std::cout << evaluate::to_table(result);
  return 0;
}

}  // namespace

Verb add_evaluate_graph(CLI::App& group) {
  auto arguments = std::make_shared<GraphArguments>();
  CLI::App* command = group.add_subcommand(
      "graph",
      "Global minimisation and loop closing, on synthetic graphs, identical offices and a simulated ring");
  command->add_option("--seeds", arguments->config.seeds, "How many seeds each figure is over")
      ->check(whole_number_in(1, 100000))
      ->capture_default_str();
  command->add_option("--offices", arguments->config.offices, "Identical offices along the corridor")
      ->check(whole_number_in(2, 1000))
      ->capture_default_str();
  add_report_files(*command, arguments->files);
  command->add_flag("--without-ring", arguments->without_ring, "Leave out the simulated four-room ring");
  return {command, [arguments] { return run(*arguments); }};
}

}  // namespace enfilade
