// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "interfaces/geometry/pose2.hpp"

namespace enfilade::topo_graph {

/// A room's unknowns: T_map_room (eq. 17) and the sizes, which may vary within their uncertainty.
struct RoomNode {
  Pose2 T_map_room;
  double width_m = 0.0;
  double height_m = 0.0;
  double sigma_width_m = 0.01;
  double sigma_height_m = 0.01;
};

/// One side of a door: a point on wall `wall` of a room (counted as in Rectangle), `offset_m` from the wall's
/// middle, counter-clockwise.
struct FaceNode {
  std::size_t room = 0;
  int wall = 0;
  double offset_m = 0.0;
  double sigma_offset_m = 0.02;
};

/// A door that joins two rooms: along the wall its faces coincide, across it they differ by its thickness.
struct DoorFactor {
  FaceNode a, b;
  double thickness_m = 0.15;  ///< prior of t; t ≥ 0
  double sigma_thickness_m = 0.05;
  double turn_rad = 0.0;           ///< by which the walls were measured to miss being parallel
  double sigma_position_m = 0.01;  ///< of both coordinates, beside the uncertainty of offsets and sizes
  double sigma_direction_rad = 0.009;
  bool loop = false;  ///< inferred, not driven through: it may be wrong, so its pull is limited
};

/// What odometry measured from one room's frame to another's.
struct OdometryFactor {
  std::size_t from = 0;
  std::size_t to = 0;
  Pose2 T_from_to;
  double sigma_position_m = 0.1;
  double sigma_yaw_rad = 0.05;
};

/// The graph as a least-squares problem. Room 0 stays where it is.
struct GraphProblem {
  std::vector<RoomNode> rooms;
  std::vector<DoorFactor> doors;
  std::vector<OdometryFactor> odometry;
};

/// A door's own parameters at the minimum.
struct DoorSolution {
  double thickness_m = 0.0;
  double offset_a_m = 0.0;
  double offset_b_m = 0.0;
  double weight =
      1.0;  ///< what the robust loss leaves of the door's pull: near 0 for one that cannot be true
};

struct GraphSolution {
  std::vector<RoomNode> rooms;
  std::vector<DoorSolution> doors;
  double initial_cost = 0.0;  ///< ½ Σ ρ(‖residual‖²), all residuals weighted
  double final_cost = 0.0;
  double xi_m2 = 0.0;  ///< eq. 21 over all doors, thickness taken out (kept in with error: paper)
  int iterations = 0;
  bool converged = false;
};

}  // namespace enfilade::topo_graph
