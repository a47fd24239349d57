// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/optimise/graph_solver.hpp"

#include <gtest/gtest.h>

#include "components/topoGraph/core/optimise/marginals.hpp"
#include "tools/evaluate/graph/synthetic_graph.hpp"

namespace enfilade::topo_graph {
namespace {

using evaluate::Building;
using evaluate::GraphNoise;
using evaluate::make_graph;
using evaluate::position_rmse_m;
using evaluate::SyntheticSpec;

constexpr SolverConfig kFromTree{.start = StartFrom::kTree};

double square(double value) { return value * value; }

TEST(GraphSolver, FindsTheTruthWhereDoorsAreExact) {
  const GraphNoise exact{
      .size_m = 1e-6, .offset_m = 1e-6, .direction_rad = 1e-6, .thickness_m = 0.0, .crooked_rad = 0.0};
  for (const Building building : {Building::kGrid, Building::kRing, Building::kCorridor}) {
    auto graph = make_graph({.building = building, .rooms = 25, .noise = exact});
    for (DoorFactor& door : graph.problem.doors) door.sigma_thickness_m = door.sigma_position_m = 1e-6;
    const GraphSolution solution = make_solver(kFromTree)->solve(graph.problem);
    EXPECT_TRUE(solution.converged);
    EXPECT_GT(position_rmse_m(graph.problem.rooms, graph.truth), 0.1);
    EXPECT_LT(position_rmse_m(solution.rooms, graph.truth), 1e-3);
  }
}

TEST(GraphSolver, ReachesWhatTheCovariancePredicts) {
  double after = 0.0, before = 0.0, predicted = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto graph = make_graph({.rooms = 36, .loops = 15, .seed = seed});
    const GraphSolution solution = make_solver(kFromTree)->solve(graph.problem);
    before += square(position_rmse_m(graph.problem.rooms, graph.truth));
    after += square(position_rmse_m(solution.rooms, graph.truth));
    predicted += square(Marginals(graph.problem, graph.truth, kFromTree).position_rmse_m());
  }
  EXPECT_LT(std::sqrt(after), 1.2 * std::sqrt(predicted));
  EXPECT_GT(std::sqrt(after), 0.7 * std::sqrt(predicted));
  EXPECT_LT(std::sqrt(after), 0.1 * std::sqrt(before));
}

TEST(GraphSolver, IsNotHarmedByFalseDoors) {
  double clean_sum = 0.0, dirty_sum = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SyntheticSpec spec{.seed = seed};
    const auto clean = make_graph(spec);
    spec.false_doors = 20;
    const auto dirty = make_graph(spec);
    const auto solver = make_solver(kFromTree);
    clean_sum += square(position_rmse_m(solver->solve(clean.problem).rooms, clean.truth));
    const GraphSolution solution = solver->solve(dirty.problem);
    dirty_sum += square(position_rmse_m(solution.rooms, dirty.truth));
    int disbelieved = 0;
    for (std::size_t i = clean.problem.doors.size(); i < solution.doors.size(); ++i)
      disbelieved += solution.doors[i].weight < 0.1;
    EXPECT_GE(disbelieved, 19);
  }
  EXPECT_LT(std::sqrt(dirty_sum), 1.2 * std::sqrt(clean_sum));
}

TEST(GraphSolver, LeavesTheFirstRoomWhereItIs) {
  auto graph = make_graph({.rooms = 16});
  const Pose2 first{3.0, -2.0, 0.7};
  for (RoomNode& room : graph.problem.rooms) room.T_map_room = first * room.T_map_room;
  for (const SolverKind kind : {SolverKind::kCeres, SolverKind::kSgd}) {
    const auto solution = make_solver({.solver = kind})->solve(graph.problem);
    EXPECT_EQ(solution.rooms[0].T_map_room, first);
    EXPECT_LT(solution.final_cost, 0.5 * solution.initial_cost);
  }
}

TEST(GraphSolver, KeepsConfidentSizesAlmostUnchanged) {
  auto graph = make_graph({.rooms = 16});
  const auto largest_change = [&](double sigma_m) {
    for (RoomNode& room : graph.problem.rooms) room.sigma_width_m = room.sigma_height_m = sigma_m;
    const auto solution = make_solver(kFromTree)->solve(graph.problem);
    double largest = 0.0;
    for (std::size_t i = 0; i < solution.rooms.size(); ++i)
      largest = std::max(largest, std::abs(solution.rooms[i].width_m - graph.problem.rooms[i].width_m));
    return largest;
  };
  EXPECT_LT(largest_change(1e-4), 1e-4);
  EXPECT_GT(largest_change(0.05), 1e-3);
}

// Two rooms, eq. 21 alone: the midpoints become one point, though the wall has a thickness.
TEST(GraphSolver, MinimisesEquation21ToTheLetter) {
  GraphProblem problem;
  problem.rooms = {{{}, 4.0, 3.0}, {{4.15, 0.1, 0.02}, 4.0, 3.0}};
  problem.doors = {{.a = {.room = 0, .wall = 0}, .b = {.room = 1, .wall = 2}}};
  const GraphSolution solution = make_solver({.error = DoorError::kPaper})->solve(problem);
  EXPECT_GT(solution.initial_cost, 1.0);
  EXPECT_LT(solution.xi_m2, 1e-12);
}

TEST(Marginals, GrowWithTheWayFromTheFirstRoomAndShrinkWithLoops) {
  const auto chain = make_graph({.building = Building::kRing, .rooms = 20, .loops = 0});
  const auto ring = make_graph({.building = Building::kRing, .rooms = 20, .loops = 1});
  const Marginals open(chain.problem, chain.truth, {}), closed(ring.problem, ring.truth, {});
  EXPECT_LT(open.pose(0).norm(), 1e-6);
  EXPECT_LT(open.pose(3).trace(), open.pose(15).trace());
  EXPECT_LT(closed.pose(19).trace(), 0.2 * open.pose(19).trace());
  EXPECT_LT((open.relative_pose(0, 7) - open.pose(7)).norm(), 1e-5);  // room 0 is the map's frame here
}

TEST(GraphSolver, RefusesNonsense) {
  EXPECT_THROW(make_solver({.cauchy_scale = 0.0}), std::invalid_argument);
  EXPECT_THROW(make_solver({.max_iterations = 0}), std::invalid_argument);
  EXPECT_TRUE(make_solver({})->solve({}).rooms.empty());
}

}  // namespace
}  // namespace enfilade::topo_graph
