// SPDX-License-Identifier: Apache-2.0
#include "tools/enfilade/launch/demo.hpp"

#include <cstdlib>
#include <memory>

#include "tools/enfilade/verbs/verbs.hpp"

namespace enfilade {

Verb add_demo(CLI::App& app) {
  auto options = std::make_shared<launch::DemoOptions>();
  auto settings = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand(
      "demo",
      "Explore a simulated world, or look at a recorded scan, with the components as processes on DDS");
  command->add_option("--world", options->world, "World file; the paper's two rooms by default");
  command->add_option("--input", options->input,
                      "A recorded 3D scan (.pcd, .3d) to look at instead of a world");
  command->add_option("--speed", options->speed, "At most so many times as fast as real time")
      ->check(CLI::Range(0.05, 100.0));
  CLI::Option* seed = command->add_option("--seed", options->seed, "Seed of the simulator's noise");
  command->add_option("--out", options->out,
                      "Folder for report, map, pictures and logs; out/<time> by default");
  command
      ->add_option("--domain", options->domain, "DDS domain; ENFILADE_DOMAIN, ROS_DOMAIN_ID or 0 by default")
      ->check(CLI::Range(0, 232));
  command
      ->add_option("--set", *settings, "COMPONENT.KEY=VALUE: override one configuration key; may be repeated")
      ->allow_extra_args(false);
  return {command, [options, settings, seed] {
            options->seed_given = seed->count() > 0;
            options->settings = Settings(*settings);
            // Whatever is killed here is started again, and must not leave a lock of Fast DDS taken.
            setenv("ENFILADE_SHARED_MEMORY", "off", 0);
            return options->input.empty() ? launch::run_simulated_demo(*options)
                                          : launch::run_replay_demo(*options);
          }};
}

}  // namespace enfilade
