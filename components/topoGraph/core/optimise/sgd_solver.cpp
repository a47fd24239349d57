// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "components/topoGraph/core/optimise/graph_solver.hpp"

namespace enfilade::topo_graph {
namespace {

/// A constraint between two rooms of the sequence, `from` < `to`.
struct Link {
  std::size_t from = 0;
  std::size_t to = 0;
  const DoorFactor* door = nullptr;  ///< one of the two is set
  const OdometryFactor* odometry = nullptr;
  Eigen::Vector3d sigma = Eigen::Vector3d::Ones();  ///< of x, y, yaw
};

double variance(double sigma) { return sigma * sigma; }

Link link_of(const DoorFactor& door) {
  const double along =
      variance(door.sigma_position_m) + variance(door.a.sigma_offset_m) + variance(door.b.sigma_offset_m);
  const double across = variance(door.sigma_position_m) + variance(door.sigma_thickness_m);
  const double position = std::sqrt(0.5 * (along + across));
  return {.from = std::min(door.a.room, door.b.room),
          .to = std::max(door.a.room, door.b.room),
          .door = &door,
          .sigma = {position, position, door.sigma_direction_rad}};
}

Link link_of(const OdometryFactor& odometry) {
  return {.from = std::min(odometry.from, odometry.to),
          .to = std::max(odometry.from, odometry.to),
          .odometry = &odometry,
          .sigma = {odometry.sigma_position_m, odometry.sigma_position_m, odometry.sigma_yaw_rad}};
}

std::vector<Link> links_of(const GraphProblem& problem, DoorError error) {
  std::vector<Link> links;
  for (const DoorFactor& door : problem.doors)
    if (door.a.room != door.b.room) links.push_back(link_of(door));
  if (error == DoorError::kPaper) return links;
  for (const OdometryFactor& odometry : problem.odometry) links.push_back(link_of(odometry));
  return links;
}

/// Olson, Leonard and Teller's stochastic gradient descent, the method of [12] that the paper names: one
/// constraint at a time displaces the rooms of the sequence between its two ends, each by its share of the
/// way, with a step that falls as 1/t from "all of the error at once".
class SgdSolver final : public GraphSolver {
 public:
  explicit SgdSolver(const SolverConfig& config) : config_(config) {}

  GraphSolution solve(const GraphProblem& problem) const override {
    if (problem.rooms.empty()) return {};
    std::vector<RoomVector> rooms = start_values(problem, config_);
    const double initial_cost = total_cost(problem, rooms, config_);
    const std::vector<Link> links = links_of(problem, config_.error);
    const std::vector<Eigen::Vector3d> stiffness = stiffness_of(links, rooms.size());
    const Eigen::Vector3d weakest = weakest_information(links);
    for (int t = 1; t <= config_.sgd_iterations; ++t) {
      for (const Link& link : links) step(link, stiffness, weakest * t, rooms);
    }
    GraphSolution solution = solution_at(problem, rooms, config_);
    solution.initial_cost = initial_cost;
    solution.iterations = config_.sgd_iterations;
    solution.converged = solution.final_cost <= initial_cost;
    return solution;
  }

 private:
  /// M of the method: what all constraints together say about each step of the sequence.
  static std::vector<Eigen::Vector3d> stiffness_of(const std::vector<Link>& links, std::size_t rooms) {
    std::vector<Eigen::Vector3d> change(rooms + 1, Eigen::Vector3d::Zero());
    for (const Link& link : links) {
      const Eigen::Vector3d information = link.sigma.cwiseAbs2().cwiseInverse();
      change[link.from + 1] += information;
      change[link.to + 1] -= information;
    }
    for (std::size_t i = 1; i <= rooms; ++i) change[i] += change[i - 1];
    return change;
  }

  /// γ of the method: the step of t = 1 takes away the whole error of any constraint.
  static Eigen::Vector3d weakest_information(const std::vector<Link>& links) {
    Eigen::Vector3d weakest = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    for (const Link& link : links) weakest = weakest.cwiseMin(link.sigma.cwiseAbs2().cwiseInverse());
    return weakest;
  }

  /// How far `to` must move, seen from `from`, for the constraint to hold, in the map frame.
  Eigen::Vector3d shortfall(const Link& link, const std::vector<RoomVector>& rooms) const {
    if (link.odometry) {
      const OdometryFactor& odometry = *link.odometry;
      const RoomVector &from = rooms[odometry.from], &to = rooms[odometry.to];
      const Point2 wanted = from.head<2>() + rotate(from[2], odometry.T_from_to.translation());
      const double yaw = wrap_to_pi(from[2] + odometry.T_from_to.yaw_rad - to[2]);
      const Point2 shift = wanted - to.head<2>();
      const double sign = odometry.to == link.to ? 1.0 : -1.0;
      return sign * Eigen::Vector3d(shift.x(), shift.y(), yaw);
    }
    const DoorFactor& door = *link.door;
    const RoomVector &a = rooms[door.a.room], &b = rooms[door.b.room];
    const FaceGap gap = face_gap(door, a, b);
    const bool paper = config_.error == DoorError::kPaper;
    const double across = gap.across_m - (paper ? 0.0 : solve_door(door, a, b).thickness_m);
    const Point2 off = rotate(a[2] + 0.5 * kPi * door.a.wall, {across, gap.along_m});
    const double sign = door.b.room == link.to ? -1.0 : 1.0;
    return sign * Eigen::Vector3d(off.x(), off.y(), paper ? 0.0 : gap.turn_rad);
  }

  double weight(const Link& link, const std::vector<RoomVector>& rooms) const {
    if (!link.door || !link.door->loop) return 1.0;
    const DoorFactor& door = *link.door;
    const auto residual = door_residual(door, config_.error, rooms[door.a.room], rooms[door.b.room]);
    return cauchy_weight(residual.value.squaredNorm(), config_.cauchy_scale);
  }

  void step(const Link& link, const std::vector<Eigen::Vector3d>& stiffness, const Eigen::Vector3d& damping,
            std::vector<RoomVector>& rooms) const {
    const auto hops = static_cast<double>(link.to - link.from);
    const Eigen::Vector3d gain = 2.0 * hops * weight(link, rooms) * link.sigma.cwiseAbs2().cwiseInverse();
    const Eigen::Vector3d wanted =
        gain.cwiseQuotient(damping).cwiseMin(1.0).cwiseProduct(shortfall(link, rooms));
    Eigen::Vector3d total = Eigen::Vector3d::Zero();
    for (std::size_t i = link.from + 1; i <= link.to; ++i) total += stiffness[i].cwiseInverse();
    const Eigen::Vector3d share = wanted.cwiseQuotient(total);
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();
    for (std::size_t i = link.from + 1; i <= link.to; ++i) {
      moved += share.cwiseQuotient(stiffness[i]);
      rooms[i].head<3>() += moved;
    }
    for (std::size_t i = link.to + 1; i < rooms.size(); ++i) rooms[i].head<3>() += moved;
  }

  SolverConfig config_;
};

}  // namespace

std::unique_ptr<GraphSolver> make_sgd_solver(const SolverConfig& config) {
  return std::make_unique<SgdSolver>(config);
}

}  // namespace enfilade::topo_graph
