// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include <CLI/CLI.hpp>

namespace enfilade {

/// A verb adds its subcommand to `app` and returns what to call when it was chosen; that returns the exit
/// status.
struct Verb {
  CLI::App* command = nullptr;
  std::function<int()> run;
};

/// Runs the one of `verbs` that was chosen; says so where none was.
int run_chosen(const CLI::App& group, const std::vector<Verb>& verbs);

/// `enfilade run WORLD`: simulator and components in one process, faster than real time.
Verb add_run(CLI::App& app);
/// `enfilade demo`: simulator and components as processes on DDS.
Verb add_demo(CLI::App& app);
/// `enfilade room FILE`: the room around a point of a recorded building.
Verb add_room(CLI::App& app);
/// `enfilade map VERB FILE`: a map file shown, checked, exported.
Verb add_map(CLI::App& app);
/// `enfilade route FROM TO` and `enfilade mark DOOR closed|open`: questions to a system that runs.
Verb add_route(CLI::App& app);
Verb add_mark(CLI::App& app);
/// The word "closed" or "open".
void add_closed_or_open(CLI::App& command, bool& closed);
/// `enfilade evaluate EXPERIMENT`: how good the parts are, on random inputs of which the truth is known.
Verb add_evaluate(CLI::App& app);
Verb add_evaluate_perception(CLI::App& group);
Verb add_evaluate_graph(CLI::App& group);
Verb add_evaluate_maps(CLI::App& group);
Verb add_evaluate_exploration(CLI::App& group);
Verb add_evaluate_latency(CLI::App& group);
/// `enfilade calibrate range`: what the laser measures too much.
Verb add_calibrate(CLI::App& app);

}  // namespace enfilade
