// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/optimise/graph_solver.hpp"

#include <cmath>
#include <stdexcept>

#include "components/topoGraph/core/optimise/spanning_tree.hpp"
#include "interfaces/geometry/square.hpp"

namespace enfilade::topo_graph {
namespace {

double cauchy(double squared_norm, double scale) {
  return square(scale) * std::log1p(squared_norm / square(scale));
}

/// One term of eq. 21.
double squared_gap(const FaceGap& gap, double thickness_m, DoorError error) {
  const double across_m = gap.across_m - (error == DoorError::kPaper ? 0.0 : thickness_m);
  return square(gap.along_m) + square(across_m);
}

}  // namespace

std::unique_ptr<GraphSolver> make_solver(const SolverConfig& config) {
  if (config.cauchy_scale <= 0.0 || config.max_iterations < 1 || config.tolerance <= 0.0 ||
      config.sgd_iterations < 1) {
    throw std::invalid_argument("GraphSolver: scale, iterations and tolerance must be positive");
  }
  return config.solver == SolverKind::kCeres ? make_ceres_solver(config) : make_sgd_solver(config);
}

double total_cost(const GraphProblem& problem, const std::vector<RoomVector>& rooms,
                  const SolverConfig& config) {
  double twice = 0.0;
  for (const DoorFactor& door : problem.doors) {
    const double s =
        door_residual(door, config.error, rooms[door.a.room], rooms[door.b.room]).value.squaredNorm();
    twice += door.loop ? cauchy(s, config.cauchy_scale) : s;
  }
  if (config.error != DoorError::kPaper) {
    for (const OdometryFactor& odometry : problem.odometry)
      twice += odometry_residual(odometry, rooms[odometry.from], rooms[odometry.to]).value.squaredNorm();
  }
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const RoomNode& room = problem.rooms[i];
    twice += square((rooms[i][3] - room.width_m) / room.sigma_width_m) +
             square((rooms[i][4] - room.height_m) / room.sigma_height_m);
  }
  return 0.5 * twice;
}

std::vector<RoomVector> start_values(const GraphProblem& problem, const SolverConfig& config) {
  std::vector<RoomVector> rooms;
  rooms.reserve(problem.rooms.size());
  for (const RoomNode& room : problem.rooms) rooms.push_back(to_vector(room));
  if (config.start == StartFrom::kGiven) return rooms;
  const std::vector<Pose2> poses = tree_poses(problem);
  for (std::size_t i = 0; i < rooms.size(); ++i)
    rooms[i].head<3>() << poses[i].x_m, poses[i].y_m, poses[i].yaw_rad;
  return rooms;
}

GraphSolution solution_at(const GraphProblem& problem, const std::vector<RoomVector>& rooms,
                          const SolverConfig& config) {
  GraphSolution solution{.rooms = problem.rooms};
  for (std::size_t i = 0; i < rooms.size(); ++i) from_vector(rooms[i], solution.rooms[i]);
  for (const DoorFactor& door : problem.doors) {
    const RoomVector &a = rooms[door.a.room], &b = rooms[door.b.room];
    DoorSolution solved = solve_door(door, a, b);
    const double s = door_residual(door, config.error, a, b).value.squaredNorm();
    if (door.loop) solved.weight = cauchy_weight(s, config.cauchy_scale);
    solution.xi_m2 += squared_gap(face_gap(door, a, b), solved.thickness_m, config.error);
    solution.doors.push_back(solved);
  }
  solution.final_cost = total_cost(problem, rooms, config);
  return solution;
}

}  // namespace enfilade::topo_graph
