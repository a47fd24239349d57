// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tools/evaluate/exploration/random_building.hpp"
#include "tools/launch/settings.hpp"

namespace enfilade::evaluate {

struct ExplorationConfig {
  int buildings = 20;
  BuildingSpec spec;        ///< of the first building; each further one has the next seed
  std::string worlds;       ///< folder that keeps the world files; "" = none
  bool only_write = false;  ///< world files alone, nothing is explored
  Settings settings;        ///< of the components
  double max_sim_time_s = 5400.0;
};

/// One exploration. "Right" is what matches a true room or door.
struct ExplorationRow {
  std::uint64_t seed = 0;
  bool finished = false;
  std::string ended_with;  ///< the explorer's last words
  int rooms_true = 0, rooms_found = 0, rooms_right = 0;
  int doors_true = 0, doors_found = 0, doors_right = 0;
  int collisions = 0;
  std::optional<double> size_error_mean_m, size_error_max_m, centre_error_mean_m;
  double sim_time_s = 0.0, wall_time_s = 0.0;
};

struct ExplorationTotals {
  int buildings = 0, finished = 0, flawless = 0;  ///< flawless: finished, everything right, nothing touched
  int rooms_true = 0, rooms_found = 0, rooms_right = 0;
  int doors_true = 0, doors_found = 0, doors_right = 0;
  int collisions = 0;
  double size_error_mean_m = 0.0, size_error_max_m = 0.0;
};

/// Explores random buildings one after the other; `tell` hears of each as it ends.
std::vector<ExplorationRow> evaluate_explorations(const ExplorationConfig& config,
                                                  const std::function<void(const ExplorationRow&)>& tell);

bool is_flawless(const ExplorationRow& row);
ExplorationTotals sum_up(const std::vector<ExplorationRow>& rows);

std::string to_line(const ExplorationRow& row);
std::string to_text(const ExplorationTotals& totals);
std::string to_json(const std::vector<ExplorationRow>& rows);

}  // namespace enfilade::evaluate
