// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "tools/enfilade/verbs/verbs.hpp"

namespace enfilade {

Verb add_evaluate(CLI::App& app) {
  CLI::App* group =
      app.add_subcommand("evaluate", "Measure the parts of the system on inputs of which the truth is known");
  const std::vector<Verb> experiments{add_evaluate_perception(*group), add_evaluate_graph(*group),
                                      add_evaluate_exploration(*group), add_evaluate_latency(*group),
                                      add_evaluate_maps(*group)};
  return {group, [group, experiments] { return run_chosen(*group, experiments); }};
}

}  // namespace enfilade
