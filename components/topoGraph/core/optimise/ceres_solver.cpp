// SPDX-License-Identifier: Apache-2.0
#include <ceres/ceres.h>

#include "components/topoGraph/core/optimise/graph_solver.hpp"

namespace enfilade::topo_graph {
namespace {

RoomVector room_at(double const* const* parameters, int index) {
  return Eigen::Map<const RoomVector>(parameters[index]);
}

/// Hands a residual of ours with its analytic derivatives to Ceres.
bool hand_over(const Residual& residual, double* values, double** jacobians) {
  Eigen::Map<Eigen::Vector3d>{values} = residual.value;
  if (!jacobians) return true;
  if (jacobians[0]) Eigen::Map<RoomJacobian>{jacobians[0]} = residual.by_a;
  if (jacobians[1]) Eigen::Map<RoomJacobian>{jacobians[1]} = residual.by_b;
  return true;
}

class DoorCost final : public ceres::SizedCostFunction<3, 5, 5> {
 public:
  DoorCost(const DoorFactor& door, DoorError error) : door_(door), error_(error) {}
  bool Evaluate(double const* const* rooms, double* values, double** jacobians) const override {
    return hand_over(door_residual(door_, error_, room_at(rooms, 0), room_at(rooms, 1)), values, jacobians);
  }

 private:
  const DoorFactor& door_;
  DoorError error_;
};

class OdometryCost final : public ceres::SizedCostFunction<3, 5, 5> {
 public:
  explicit OdometryCost(const OdometryFactor& odometry) : odometry_(odometry) {}
  bool Evaluate(double const* const* rooms, double* values, double** jacobians) const override {
    return hand_over(odometry_residual(odometry_, room_at(rooms, 0), room_at(rooms, 1)), values, jacobians);
  }

 private:
  const OdometryFactor& odometry_;
};

/// "High-confident parameters remain almost unchanged": the sizes stay within their uncertainty.
class SizeCost final : public ceres::SizedCostFunction<2, 5> {
 public:
  explicit SizeCost(const RoomNode& room) : room_(room) {}
  bool Evaluate(double const* const* rooms, double* values, double** jacobians) const override {
    values[0] = (rooms[0][3] - room_.width_m) / room_.sigma_width_m;
    values[1] = (rooms[0][4] - room_.height_m) / room_.sigma_height_m;
    if (!jacobians || !jacobians[0]) return true;
    Eigen::Map<Eigen::Matrix<double, 2, 5, Eigen::RowMajor>> jacobian(jacobians[0]);
    jacobian.setZero();
    jacobian(0, 3) = 1.0 / room_.sigma_width_m;
    jacobian(1, 4) = 1.0 / room_.sigma_height_m;
    return true;
  }

 private:
  const RoomNode& room_;
};

class CeresSolver final : public GraphSolver {
 public:
  explicit CeresSolver(const SolverConfig& config) : config_(config) {}

  GraphSolution solve(const GraphProblem& problem) const override {
    if (problem.rooms.empty()) return {};
    std::vector<RoomVector> rooms = start_values(problem, config_);
    ceres::CauchyLoss cauchy(config_.cauchy_scale);
    ceres::Problem ceres_problem(problem_options());
    add_costs(ceres_problem, problem, rooms, cauchy);
    ceres_problem.SetManifold(rooms[0].data(), new ceres::SubsetManifold(5, {0, 1, 2}));
    ceres::Solver::Summary summary;
    ceres::Solve(solver_options(), &ceres_problem, &summary);
    GraphSolution solution = solution_at(problem, rooms, config_);
    solution.initial_cost = summary.initial_cost;
    solution.iterations = static_cast<int>(summary.iterations.size());
    solution.converged = summary.termination_type == ceres::CONVERGENCE;
    return solution;
  }

 private:
  static ceres::Problem::Options problem_options() {
    ceres::Problem::Options options;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.disable_all_safety_checks = true;
    return options;
  }

  ceres::Solver::Options solver_options() const {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.sparse_linear_algebra_library_type = ceres::SUITE_SPARSE;
    options.num_threads = 1;
    options.max_num_iterations = config_.max_iterations;
    options.function_tolerance = config_.tolerance;
    // A chain of rooms bends by far more than damping by the diagonal would let it: nearly Gauss-Newton from
    // the start. Eq. 21 alone leaves directions open, which damping closes.
    if (config_.error == DoorError::kThickness) options.initial_trust_region_radius = 1e9;
    options.logging_type = ceres::SILENT;
    return options;
  }

  void add_costs(ceres::Problem& ceres_problem, const GraphProblem& problem, std::vector<RoomVector>& rooms,
                 ceres::CauchyLoss& cauchy) const {
    for (std::size_t i = 0; i < rooms.size(); ++i)
      ceres_problem.AddResidualBlock(new SizeCost(problem.rooms[i]), nullptr, rooms[i].data());
    for (const DoorFactor& door : problem.doors)
      ceres_problem.AddResidualBlock(new DoorCost(door, config_.error), door.loop ? &cauchy : nullptr,
                                     rooms[door.a.room].data(), rooms[door.b.room].data());
    if (config_.error == DoorError::kPaper) return;
    for (const OdometryFactor& odometry : problem.odometry)
      ceres_problem.AddResidualBlock(new OdometryCost(odometry), nullptr, rooms[odometry.from].data(),
                                     rooms[odometry.to].data());
  }

  SolverConfig config_;
};

}  // namespace

std::unique_ptr<GraphSolver> make_ceres_solver(const SolverConfig& config) {
  return std::make_unique<CeresSolver>(config);
}

}  // namespace enfilade::topo_graph
