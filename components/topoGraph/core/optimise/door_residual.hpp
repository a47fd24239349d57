// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "components/topoGraph/core/optimise/graph_problem.hpp"

namespace enfilade::topo_graph {

/// (x, y, α, w, h) of one room, as the solvers see it.
using RoomVector = Eigen::Matrix<double, 5, 1>;
using RoomJacobian = Eigen::Matrix<double, 3, 5, Eigen::RowMajor>;

RoomVector to_vector(const RoomNode& room);
void from_vector(const RoomVector& vector, RoomNode& room);

/// Three residuals and their derivatives by the two rooms.
struct Residual {
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  RoomJacobian by_a = RoomJacobian::Zero();
  RoomJacobian by_b = RoomJacobian::Zero();
};

enum class DoorError : std::uint8_t {
  kPaper,  ///< the term of eq. 21 to the letter: the midpoints are one point; two equations, the third is 0
  kThickness,  ///< two of position with the wall's thickness between the faces, one of direction
};

/// How the faces lie to each other, in the frame of a's wall.
struct FaceGap {
  double along_m = 0.0;
  double across_m = 0.0;  ///< T_b·d_b − T_a·d_a along the outward normal of a's wall
  double turn_rad = 0.0;  ///< of b's wall beyond standing back to back
};
FaceGap face_gap(const DoorFactor& door, const RoomVector& a, const RoomVector& b);

/// The weighted deviation of a door's faces. Offsets and thickness are linear in it and belong to this door
/// alone: they are at their best values here (variable projection), so they are no unknowns of the solver.
Residual door_residual(const DoorFactor& door, DoorError error, const RoomVector& a, const RoomVector& b);

/// Those best values; `weight` is left at 1.
DoorSolution solve_door(const DoorFactor& door, const RoomVector& a, const RoomVector& b);

/// T_a_b by the door alone, thickness and offsets at their priors.
Pose2 pose_through(const DoorFactor& door, const RoomNode& a, const RoomNode& b);

Residual odometry_residual(const OdometryFactor& odometry, const RoomVector& from, const RoomVector& to);

}  // namespace enfilade::topo_graph
