// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/run_component.hpp"
#include "tools/simulator/node/simulator_node.hpp"

int main(int argc, char** argv) {
  using namespace enfilade;
  simulator::SimulatorConfig config;
  const ComponentRecipe recipe{
      .name = "simulator",
      .load =
          [&config](const std::string& file, const ConfigOverrides& overrides) {
            std::string resolved;
            config = load_config<simulator::SimulatorConfig>(file, overrides, &resolved);
            config.world = simulator::resolve_world(config.world, file);
            return resolved;
          },
      .period = [&config] { return config.period; },
      .make_node =
          [&config](const NodeContext& context) { return simulator::make_deployed_node(context, config); },
  };
  return run_component(recipe, argc, argv);
}
