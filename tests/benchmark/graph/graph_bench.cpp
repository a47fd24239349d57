// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "components/topoGraph/core/optimise/graph_solver.hpp"
#include "tools/evaluate/graph/synthetic_graph.hpp"

namespace enfilade {
namespace {

using topo_graph::SolverKind;

/// A building driven through once, with a loop for every ten rooms, from the poses of raw odometry.
void optimise(benchmark::State& state, SolverKind kind) {
  const int rooms = static_cast<int>(state.range(0));
  const auto graph = evaluate::make_graph({.rooms = rooms, .loops = std::max(40, rooms / 10)});
  const auto solver = topo_graph::make_solver({.solver = kind, .start = topo_graph::StartFrom::kTree});
  topo_graph::GraphSolution solution;
  for (auto _ : state) {
    solution = solver->solve(graph.problem);
    benchmark::DoNotOptimize(solution);
  }
  state.counters["rmse_m"] = evaluate::position_rmse_m(solution.rooms, graph.truth);
  state.counters["before_m"] = evaluate::position_rmse_m(graph.problem.rooms, graph.truth);
  state.counters["xi_m2"] = solution.xi_m2;
  state.counters["cost"] = solution.final_cost;
  state.counters["iterations"] = solution.iterations;
}

BENCHMARK_CAPTURE(optimise, ceres, SolverKind::kCeres)
    ->Name("Optimise/ceres")
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(optimise, sgd, SolverKind::kSgd)
    ->Name("Optimise/sgd")
    ->Arg(100)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace enfilade
