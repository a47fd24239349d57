// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "components/topoGraph/core/optimise/door_residual.hpp"
#include "components/topoGraph/core/optimise/graph_problem.hpp"

namespace enfilade::topo_graph {

enum class SolverKind : std::uint8_t { kCeres, kSgd };
enum class StartFrom : std::uint8_t {
  kGiven,  ///< the rooms' poses as they are
  kTree,   ///< poses chained from room 0 over the most certain edges
};

struct SolverConfig {
  SolverKind solver = SolverKind::kCeres;
  DoorError error = DoorError::kThickness;  ///< kPaper: eq. 21 alone, without odometry
  StartFrom start = StartFrom::kGiven;
  double cauchy_scale = 3.0;  ///< in sigmas: loop doors that miss by more lose their pull
  int max_iterations = 100;
  double tolerance = 1e-5;  ///< ceres: stop when the cost falls by a smaller share
  int sgd_iterations = 200;
};

/// Minimises ½ Σ ρ(‖residual‖²) over the rooms' poses and sizes (eq. 21, weighted). Deterministic.
class GraphSolver {
 public:
  virtual ~GraphSolver() = default;
  virtual GraphSolution solve(const GraphProblem& problem) const = 0;
};

/// Throws std::invalid_argument where the configuration makes no sense.
std::unique_ptr<GraphSolver> make_solver(const SolverConfig& config);

/// The two behind it; make_solver checks the configuration.
std::unique_ptr<GraphSolver> make_ceres_solver(const SolverConfig& config);
std::unique_ptr<GraphSolver> make_sgd_solver(const SolverConfig& config);

/// ρ'(s) of the Cauchy loss c²·ln(1 + s/c²).
inline double cauchy_weight(double squared_norm, double scale) {
  return 1.0 / (1.0 + squared_norm / (scale * scale));
}

/// ½ Σ ρ(‖residual‖²) at `rooms`.
double total_cost(const GraphProblem& problem, const std::vector<RoomVector>& rooms,
                  const SolverConfig& config);

/// Start values for a solver: as given, or over the tree.
std::vector<RoomVector> start_values(const GraphProblem& problem, const SolverConfig& config);

/// Rooms, doors, cost and ξ at `rooms`; iterations and convergence are the solver's to tell.
GraphSolution solution_at(const GraphProblem& problem, const std::vector<RoomVector>& rooms,
                          const SolverConfig& config);

}  // namespace enfilade::topo_graph
