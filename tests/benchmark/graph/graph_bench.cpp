// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <benchmark/benchmark.h>

#include "components/topoGraph/core/optimise/graph_solver.hpp"
#include "components/topoGraph/metric_map/map_formats.hpp"
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

/// Rooms of 4 × 4 m in a square, walls 0.15 m thick, doors to the right and upwards.
TopologicalMap square_building(int rooms) {
  TopologicalMap map;
  const int side = static_cast<int>(std::sqrt(rooms));
  for (int i = 0; i < rooms; ++i) {
    Room room;
    room.id = static_cast<RoomId>(i + 1);
    room.T_map_room = {4.15 * (i % side), 4.15 * (i / side), 0.0};
    room.width_m = room.height_m = 4.0;
    map.rooms.push_back(room);
  }
  const auto join = [&map](int a, int b, std::uint8_t wall) {
    const DoorFace face{static_cast<RoomId>(a + 1), {wall, 1.0, 1.9}};
    const DoorFace other{static_cast<RoomId>(b + 1), {static_cast<std::uint8_t>(wall + 2), 2.1, 3.0}};
    const auto id = static_cast<DoorId>(map.doors.size() + 1);
    map.doors.push_back({.id = id, .kind = DoorKind::kPassage, .face = face, .other_face = other});
  };
  for (int i = 0; i < rooms; ++i) {
    if (i % side + 1 < side) join(i, i + 1, 0);
    if (i + side < rooms) join(i, i + side, 1);
  }
  return map;
}

/// The occupancy grid of the building at 0.05 m.
void metric_map(benchmark::State& state) {
  const TopologicalMap map = square_building(static_cast<int>(state.range(0)));
  topo_graph::OccupancyGrid grid;
  for (auto _ : state) {
    grid = topo_graph::draw_metric_map(map, {.resolution_m = 0.05});
    benchmark::DoNotOptimize(grid.cells.data());
  }
  state.counters["cells"] = static_cast<double>(grid.cells.size());
}

/// The same building as an OctoMap file, grid included.
void octomap_file(benchmark::State& state) {
  const TopologicalMap map = square_building(static_cast<int>(state.range(0)));
  std::string file;
  for (auto _ : state) {
    file = topo_graph::to_octomap(topo_graph::draw_metric_map(map, {.resolution_m = 0.05}));
    benchmark::DoNotOptimize(file.data());
  }
  state.counters["bytes_per_room"] = static_cast<double>(file.size()) / static_cast<double>(map.rooms.size());
}

BENCHMARK(metric_map)->Name("MetricMap")->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(octomap_file)->Name("OctoMapFile")->Arg(100)->Unit(benchmark::kMillisecond);
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
