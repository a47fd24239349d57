// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/explorer/core/exploration_machine.hpp"
#include "interfaces/runtime/config.hpp"

namespace enfilade::explorer {

struct ExplorerConfig {
  PeriodConfig period{.compute_s = 0.05,
                      .emergency_s = 0.1};  ///< compute_s is the period of velocity commands
  double odometry_stale_s = 0.5;            ///< without odometry or points for so long the base stands
  double points_stale_s = 1.0;
  double state_period_s = 0.5;
  ProjectedGridConfig grid;
  MachineConfig machine;
};

void bind(ConfigBinder& c, ExplorerConfig& config);

}  // namespace enfilade::explorer
