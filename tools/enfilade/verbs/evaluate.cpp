// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "tools/enfilade/verbs/verbs.hpp"

namespace enfilade {

Verb add_evaluate(CLI::App& app) {
  CLI::App* group =
      app.add_subcommand("evaluate", "Measure the parts of the system on inputs of which the truth is known");
  group->require_subcommand(1);
  const std::vector<Verb> experiments{add_evaluate_perception(*group), add_evaluate_graph(*group),
                                      add_evaluate_exploration(*group), add_evaluate_latency(*group),
                                      add_evaluate_maps(*group)};
  return {group, [experiments] {
            for (const Verb& experiment : experiments)
              if (experiment.command->parsed()) return experiment.run();
            return 2;
          }};
}

}  // namespace enfilade
