// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "interfaces/runtime/config.hpp"
#include "interfaces/runtime/node.hpp"

namespace enfilade {

/// What run_component needs to know of a component.
struct ComponentRecipe {
  std::string name;  ///< as in the topic table
  /// Loads the configuration; returns the resolved text, and keeps the config for make_node.
  std::function<std::string(const std::string& file, const ConfigOverrides& overrides)> load;
  std::function<PeriodConfig()> period;
  std::function<std::unique_ptr<Node>(const NodeContext&)> make_node;
};

/// The body of every component's main: parses the command line
///   NAME [--config FILE] [--set KEY=VALUE]… [--domain N] [--sim-time] [--log-level LEVEL]
/// loads the configuration (default: etc/NAME.yaml of this checkout or install), takes the host lock (one
/// NAME per domain and host), joins DDS, drives the life cycle until SIGINT or SIGTERM, and returns the exit
/// status: 0 after a stop in good order, 2 for what it would refuse again (command line, configuration,
/// input), 1 for anything else, with one sentence on stderr.
int run_component(const ComponentRecipe& recipe, int argc, char** argv);

template <class NodeType, class Config>
int run_component(const std::string& name, int argc, char** argv) {
  Config config;
  return run_component(
      ComponentRecipe{
          .name = name,
          .load =
              [&config](const std::string& file, const ConfigOverrides& overrides) {
                std::string resolved;
                config = load_config<Config>(file, overrides, &resolved);
                return resolved;
              },
          .period = [&config] { return config.period; },
          .make_node =
              [&config](const NodeContext& context) { return std::make_unique<NodeType>(context, config); },
      },
      argc, argv);
}

}  // namespace enfilade
