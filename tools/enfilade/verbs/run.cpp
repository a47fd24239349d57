// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "components/topoGraph/storage/map_file.hpp"
#include "tools/enfilade/verbs/options.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/launch/composed_run.hpp"
#include "tools/support/files.hpp"

namespace enfilade {
namespace {

struct RunArguments {
  std::string world, json, out;
  std::uint64_t seed = 0;
  std::vector<std::string> settings, kills;
  bool wire = false, quiet = false;
  double max_sim_time_s = 3600.0;
};

void print_event(const LogLine& line) {
  if (line.level < 20) return;
  std::cerr << fmt::format("{:7.1f} s  {:<12} {}\n", seconds(line.stamp_ns), line.component_name, line.text);
}

int run(const RunArguments& arguments, bool seed_given) {
  ComposedRunOptions options{.world = arguments.world,
                             .settings = Settings(arguments.settings),
                             .through_wire = arguments.wire,
                             .max_sim_time_s = arguments.max_sim_time_s};
  options.settings.refuse("simulator", "world", "WORLD");
  if (seed_given) {
    options.settings.refuse("simulator", "seed", "--seed");
    options.seed = arguments.seed;
  }
  for (const std::string& kill : arguments.kills) options.kills.push_back(parse_kill(kill));
  if (!arguments.quiet) options.log = print_event;
  const report::Report report = run_composed(options);
  if (!arguments.out.empty()) {
    report::write_files(report, arguments.out);
    topo_graph::save_map(std::filesystem::path(arguments.out) / "map.yaml", report.record.map);
  }
  if (!arguments.json.empty()) write_file(arguments.json, report::to_json(report));
  std::cout << report::to_table(report);
  if (report.record.finished()) return 0;
  std::cerr << fmt::format("enfilade run: the exploration did not finish: {}\n",
                           report.record.ended() ? report.record.exploration.activity : "time is up");
  return 1;
}

}  // namespace

Verb add_run(CLI::App& app) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run",
                                         "Explore a world with simulator and components in this process, on "
                                         "a virtual clock, repeatable to the byte but for wall_time_s");
  command->add_option("world", arguments->world, "World file (etc/worlds/*.yaml, or a map_server map.yaml)")
      ->required();
  CLI::Option* seed = add_seed(*command, arguments->seed, "Seed of the simulator's noise");
  add_output_file(*command, "--json", arguments->json, "Write the report to this file");
  add_output_folder(*command, "--out", arguments->out,
                    "Write report.json, map.yaml and the pictures into this folder");
  add_settings(*command, arguments->settings);
  command
      ->add_option("--max-sim-time", arguments->max_sim_time_s, "Give up after this many simulated seconds")
      ->check(number_in(0.001, 1e9))
      ->capture_default_str();
  command
      ->add_option(
          "--kill", arguments->kills,
          "COMPONENT@SECONDS: kill a component then, and start it again a second later; may be repeated")
      ->allow_extra_args(false);
  command->add_flag("--wire", arguments->wire, "Serialise every message through its IDL type on the way");
  command->add_flag("--quiet", arguments->quiet, "Print only the closing table");
  return {command, [arguments, seed] { return run(*arguments, seed->count() > 0); }};
}

}  // namespace enfilade
