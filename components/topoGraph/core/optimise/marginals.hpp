// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "components/topoGraph/core/optimise/graph_solver.hpp"

namespace enfilade::topo_graph {

/// What the graph's constraints leave uncertain about its rooms: the maximum-likelihood covariance at
/// `rooms`, room 0 fixed. Factorised once, asked room by room.
class Marginals {
 public:
  Marginals(const GraphProblem& problem, const std::vector<RoomNode>& rooms, const SolverConfig& config);
  ~Marginals();
  Marginals(Marginals&&) noexcept;
  Marginals& operator=(Marginals&&) noexcept;

  /// Of (x, y, yaw) of T_map_room.
  Eigen::Matrix3d pose(std::size_t room) const;
  /// Of the pose of `room` as seen from the frame of `from`.
  Eigen::Matrix3d relative_pose(std::size_t from, std::size_t room) const;
  /// √ of the mean of the rooms' position variances (trace): the RMSE that the best estimate can have.
  double position_rmse_m() const;

 private:
  struct Factorised;
  std::unique_ptr<Factorised> factorised_;
  std::vector<RoomNode> rooms_;
};

}  // namespace enfilade::topo_graph
