// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <vector>

#include "tools/evaluate/graph/synthetic_graph.hpp"

namespace enfilade::evaluate {

/// A cell of the plan: walls included, in building coordinates.
struct Cell {
  double x_m = 0.0;
  double y_m = 0.0;
  double width_m = 0.0;
  double height_m = 0.0;
};

/// Two cells side by side: b lies beyond wall `wall` of a (0 east, 1 north, as in Rectangle).
struct Passage {
  std::size_t a = 0;
  std::size_t b = 0;
  int wall = 0;
};

struct BuildingPlan {
  std::vector<Cell> cells;
  std::vector<Passage> driven;  ///< in the order of driving; each leads to a new cell
  std::vector<Passage> loops;   ///< the other doors
};

BuildingPlan make_plan(const SyntheticSpec& spec, std::mt19937_64& random);

}  // namespace enfilade::evaluate
