// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/graph/graph_evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "components/topoGraph/core/optimise/marginals.hpp"
#include "tools/evaluate/graph/journal_kills.hpp"
#include "tools/evaluate/graph/room_stream.hpp"

namespace enfilade::evaluate {
namespace {

using topo_graph::SolverConfig;
using topo_graph::SolverKind;
using topo_graph::StartFrom;

constexpr SolverConfig kFromTree{.start = StartFrom::kTree};

std::string name_of(Building building) {
  return building == Building::kGrid ? "grid" : building == Building::kRing ? "ring" : "corridor";
}

double square(double value) { return value * value; }

SolverRow run_solver(const SyntheticSpec& spec, SolverKind kind) {
  const SyntheticGraph graph = make_graph(spec);
  SolverConfig config = kFromTree;
  config.solver = kind;
  const auto solver = topo_graph::make_solver(config);
  const std::clock_t begin = std::clock();
  const topo_graph::GraphSolution solution = solver->solve(graph.problem);
  const double time_ms = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return {.building = name_of(spec.building),
          .rooms = static_cast<int>(graph.truth.size()),
          .loops = graph.loops,
          .solver = kind == SolverKind::kCeres ? "ceres" : "sgd",
          .time_ms = time_ms,
          .cost = solution.final_cost,
          .xi_m2 = solution.xi_m2,
          .rmse_m = position_rmse_m(solution.rooms, graph.truth)};
}

}  // namespace

RmseRow measure_rmse(SyntheticSpec spec, int seeds) {
  RmseRow row{.building = name_of(spec.building), .false_doors = spec.false_doors};
  const auto solver = topo_graph::make_solver(kFromTree);
  for (int seed = 1; seed <= seeds; ++seed) {
    spec.seed = static_cast<std::uint64_t>(seed);
    const SyntheticGraph graph = make_graph(spec);
    SyntheticSpec clean = spec;
    clean.false_doors = 0;
    row.rooms = static_cast<int>(graph.truth.size());
    row.before_m += square(position_rmse_m(graph.problem.rooms, graph.truth));
    row.after_m += square(position_rmse_m(solver->solve(graph.problem).rooms, graph.truth));
    const topo_graph::Marginals marginals(make_graph(clean).problem, graph.truth, kFromTree);
    row.predicted_m += square(marginals.position_rmse_m());
  }
  for (double* value : {&row.before_m, &row.after_m, &row.predicted_m}) *value = std::sqrt(*value / seeds);
  return row;
}

std::vector<SolverRow> compare_solvers() {
  std::vector<SolverRow> rows;
  for (const Building building : {Building::kGrid, Building::kRing, Building::kCorridor}) {
    for (const int rooms : {100, 1000}) {
      const SyntheticSpec spec{.building = building, .rooms = rooms, .loops = std::max(40, rooms / 10)};
      for (const SolverKind kind : {SolverKind::kCeres, SolverKind::kSgd})
        rows.push_back(run_solver(spec, kind));
    }
  }
  rows.push_back(run_solver({.rooms = 10000, .loops = 1000}, SolverKind::kCeres));
  return rows;
}

OfficeResult explore_offices(const GraphEvaluationConfig& config) {
  OfficeResult result;
  for (int seed = 1; seed <= config.seeds; ++seed) {
    // By turns one long corridor, and one in identical sections: there drift adds up from section to section.
    const TrueBuilding building = office_corridor(config.offices, seed % 2 == 0 ? config.offices : 4);
    const StreamResult run = explore(building, {}, config.graph, static_cast<std::uint64_t>(seed));
    result.false_closures += run.false_closures;
    result.missed_rooms += run.missed_rooms;
    result.duplicates += run.duplicates;
    result.pose_error_max_m = std::max(result.pose_error_max_m, run.pose_error_max_m);
  }
  return result;
}

std::optional<JournalResult> kill_journal(int kills) {
  const JournalKills result = kill_writers(kills, 1);
  return JournalResult{.kills = result.kills, .lost_rooms = result.lost_rooms};
}

GraphReport evaluate_graph(const GraphEvaluationConfig& config) {
  GraphReport report{.config = config};
  report.grid100 = measure_rmse({}, config.seeds);
  report.ring100 = measure_rmse({.building = Building::kRing}, config.seeds);
  report.rmse = {report.grid100, measure_rmse({.false_doors = 20}, config.seeds), report.ring100,
                 measure_rmse({.building = Building::kCorridor}, config.seeds)};
  report.solvers = compare_solvers();
  report.offices = explore_offices(config);
  if (!config.ring_world.empty()) report.ring4 = explore_ring4(config.ring_world);
  report.journal = kill_journal(200);
  return report;
}

}  // namespace enfilade::evaluate
