// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "interfaces/runtime/config.hpp"
#include "tools/simulator/core/simulation.hpp"
#include "tools/simulator/node/pacer.hpp"

namespace enfilade::simulator {

struct SimulatorConfig {
  std::string world =
      "worlds/paper_two_rooms.yaml";  ///< absolute, or relative to the folder of the configuration file
  int seed = 1;
  double ground_truth_hz = 20.0;
  SimulationConfig simulation;  ///< its seed is `seed`
  CreditPacerConfig pacing;     ///< its speed is the key `speed`
  PeriodConfig period{.compute_s = 0.005};
};

void bind(ConfigBinder& c, SimulatorConfig& config);

/// `world` as a path that exists: as it stands, or below the folder of `config_file`. Left alone where
/// neither exists.
std::string resolve_world(const std::string& world, const std::string& config_file);

}  // namespace enfilade::simulator
