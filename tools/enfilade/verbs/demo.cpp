// SPDX-License-Identifier: Apache-2.0
#include "tools/launch/demo.hpp"

#include <cstdlib>
#include <memory>

#include "tools/enfilade/verbs/options.hpp"
#include "tools/enfilade/verbs/verbs.hpp"
#include "tools/launch/composed_run.hpp"

namespace enfilade {
namespace {

/// What the options of the demo tell cannot be set as well.
void refuse_told(const launch::DemoOptions& options) {
  const Settings& settings = options.settings;
  if (!options.input.empty()) {
    settings.refuse("laser3D", "driver", "--input");
    settings.refuse("laser3D", "replay.file", "--input");
    settings.refuse("gridBuilder", "stationary", "--input");
    return;
  }
  settings.refuse("simulator", "world", "--world");
  settings.refuse("simulator", "speed", "--speed");
  if (options.seed_given) settings.refuse("simulator", "seed", "--seed");
  settings.refuse("topoGraph", "map_file", "--out");
  settings.refuse("topoGraph", "resume", "--out");
}

}  // namespace

Verb add_demo(CLI::App& app) {
  auto options = std::make_shared<launch::DemoOptions>();
  auto settings = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand(
      "demo",
      "Explore a simulated world, or look at a recorded scan, with the components as processes on DDS");
  CLI::Option* world =
      command->add_option("--world", options->world, "World file; the paper's two rooms by default");
  CLI::Option* speed =
      command->add_option("--speed", options->speed, "At most so many times as fast as real time")
          ->check(number_in(0.05, 100.0))
          ->capture_default_str();
  CLI::Option* seed = add_seed(*command, options->seed, "Seed of the simulator's noise");
  command
      ->add_option("--input", options->input, "A recorded 3D scan (.pcd, .3d) to look at instead of a world")
      ->excludes(world, speed, seed);
  add_output_folder(*command, "--out", options->out,
                    "Folder for report, map, pictures and logs; out/<time> by default");
  add_domain(*command, options->domain);
  add_settings(*command, *settings);
  return {command, [options, settings, seed] {
            options->seed_given = seed->count() > 0;
            options->settings = Settings(*settings);
            check_settings(options->settings);
            refuse_told(*options);
            // Whatever is killed here is started again, and must not leave a lock of Fast DDS taken.
            setenv("ENFILADE_SHARED_MEMORY", "off", 0);
            return options->input.empty() ? launch::run_simulated_demo(*options)
                                          : launch::run_replay_demo(*options);
          }};
}

}  // namespace enfilade
