// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/optimise/marginals.hpp"

#include <cmath>

#include <Eigen/SparseCholesky>

namespace enfilade::topo_graph {
namespace {

constexpr double kFixed = 1e9;       // information that holds the first room's pose
constexpr double kFloating = 1e-10;  // and that keeps a room without constraints from being singular

using Triplets = std::vector<Eigen::Triplet<double>>;

/// Only one triangle is kept; the factorisation reads the lower one.
void add_block(Triplets& triplets, std::size_t row_room, std::size_t col_room,
               const Eigen::Matrix<double, 5, 5>& block) {
  for (int row = 0; row < 5; ++row) {
    for (int col = 0; col < 5; ++col) {
      const int i = static_cast<int>(5 * row_room) + row, j = static_cast<int>(5 * col_room) + col;
      if (i >= j && block(row, col) != 0.0) triplets.emplace_back(i, j, block(row, col));
    }
  }
}

void add(Triplets& triplets, std::size_t a, std::size_t b, const Residual& residual, double weight) {
  add_block(triplets, a, a, weight * residual.by_a.transpose() * residual.by_a);
  add_block(triplets, b, b, weight * residual.by_b.transpose() * residual.by_b);
  add_block(triplets, a, b, weight * residual.by_a.transpose() * residual.by_b);
  add_block(triplets, b, a, weight * residual.by_b.transpose() * residual.by_a);
}

void add_rooms(Triplets& triplets, const GraphProblem& problem) {
  for (std::size_t i = 0; i < problem.rooms.size(); ++i) {
    const RoomNode& room = problem.rooms[i];
    const double held = i == 0 ? kFixed : kFloating;
    Eigen::Matrix<double, 5, 1> information;
    information << held, held, held, 1.0 / (room.sigma_width_m * room.sigma_width_m),
        1.0 / (room.sigma_height_m * room.sigma_height_m);
    add_block(triplets, i, i, information.asDiagonal());
  }
}

/// JᵀWJ, loop doors with what the robust loss leaves of them.
Eigen::SparseMatrix<double> information(const GraphProblem& problem, const std::vector<RoomNode>& rooms,
                                        const SolverConfig& config) {
  Triplets triplets;
  add_rooms(triplets, problem);
  for (const DoorFactor& door : problem.doors) {
    const auto residual =
        door_residual(door, config.error, to_vector(rooms[door.a.room]), to_vector(rooms[door.b.room]));
    const double weight = door.loop ? cauchy_weight(residual.value.squaredNorm(), config.cauchy_scale) : 1.0;
    add(triplets, door.a.room, door.b.room, residual, weight);
  }
  for (const OdometryFactor& odometry : problem.odometry) {
    add(triplets, odometry.from, odometry.to,
        odometry_residual(odometry, to_vector(rooms[odometry.from]), to_vector(rooms[odometry.to])), 1.0);
  }
  const auto size = static_cast<int>(5 * rooms.size());
  Eigen::SparseMatrix<double> H(size, size);
  H.setFromTriplets(triplets.begin(), triplets.end());
  return H;
}

}  // namespace

struct Marginals::Factorised {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> cholesky;
  int size = 0;

  /// Columns (x, y, yaw) of the inverse that belong to `room`.
  Eigen::MatrixXd columns(std::size_t room) const {
    Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(size, 3);
    unit.middleRows(static_cast<int>(5 * room), 3).setIdentity();
    return cholesky.solve(unit);
  }
};

Marginals::Marginals(const GraphProblem& problem, const std::vector<RoomNode>& rooms,
                     const SolverConfig& config)
    : factorised_(std::make_unique<Factorised>()), rooms_(rooms) {
  factorised_->size = static_cast<int>(5 * rooms.size());
  factorised_->cholesky.compute(information(problem, rooms, config));
}

Marginals::~Marginals() = default;
Marginals::Marginals(Marginals&&) noexcept = default;
Marginals& Marginals::operator=(Marginals&&) noexcept = default;

Eigen::Matrix3d Marginals::pose(std::size_t room) const {
  return factorised_->columns(room).middleRows(static_cast<int>(5 * room), 3);
}

Eigen::Matrix3d Marginals::relative_pose(std::size_t from, std::size_t room) const {
  const Eigen::MatrixXd from_columns = factorised_->columns(from), room_columns = factorised_->columns(room);
  Eigen::Matrix<double, 6, 6> joint;
  for (const int part : {0, 1}) {
    const Eigen::MatrixXd& columns = part == 0 ? from_columns : room_columns;
    joint.block<3, 3>(0, 3 * part) = columns.middleRows(static_cast<int>(5 * from), 3);
    joint.block<3, 3>(3, 3 * part) = columns.middleRows(static_cast<int>(5 * room), 3);
  }
  const Pose2 &T_map_from = rooms_[from].T_map_room, &T_map_room = rooms_[room].T_map_room;
  const Point2 there = T_map_from.inverse() * T_map_room.translation();
  Eigen::Matrix<double, 3, 6> J = Eigen::Matrix<double, 3, 6>::Zero();
  J.block<2, 1>(0, 0) = -rotate(-T_map_from.yaw_rad, {1.0, 0.0});
  J.block<2, 1>(0, 1) = -rotate(-T_map_from.yaw_rad, {0.0, 1.0});
  J.block<2, 2>(0, 3) = -J.block<2, 2>(0, 0);
  J(0, 2) = there.y();
  J(1, 2) = -there.x();
  J(2, 2) = -1.0;
  J(2, 5) = 1.0;
  return J * joint * J.transpose();
}

double Marginals::position_rmse_m() const {
  double sum = 0.0;
  for (std::size_t room = 0; room < rooms_.size(); ++room) sum += pose(room).topLeftCorner<2, 2>().trace();
  return std::sqrt(sum / static_cast<double>(rooms_.size()));
}

}  // namespace enfilade::topo_graph
