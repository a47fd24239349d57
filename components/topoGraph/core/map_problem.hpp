// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "components/topoGraph/core/optimise/graph_problem.hpp"
#include "interfaces/model/topological_map.hpp"

namespace enfilade::topo_graph {

/// How sure the map's parameters are where nobody has estimated it; standard deviations.
struct UncertaintyConfig {
  double size_m = 0.03;               ///< of width and height, and the least that is believed of a covariance
  double door_position_m = 0.03;      ///< of a door along its wall
  double door_unseen_m = 0.30;        ///< … that was projected, not seen
  double door_direction_rad = 0.012;  ///< of two walls being parallel
  double thickness_m = 0.15;          ///< a wall's thickness as expected before it is measured
  double thickness_sigma_m = 0.05;
  double thickness_spread_m = 0.03;  ///< by which the walls of one building differ
  double crossing_sigma_m = 0.01;    ///< of a thickness measured by going through the door, beside odometry's
  double odometry_share = 0.02;      ///< of the way from room to room
  double odometry_m = 0.03;          ///< beside that
  double odometry_yaw_rad = 0.0523599;  ///< 3° from room to room
};

/// The map as eq. 21's problem: rooms in the map's order, doors that join two rooms, links. `doors[i]` is the
/// map's id of problem.doors[i].
struct MapProblem {
  GraphProblem problem;
  std::vector<DoorId> doors;
};

/// What is known of walls. Those of one building are much alike, so the ones that were measured tell of the
/// others; how far odometry can be trusted with measuring one shows in how far it missed the doors otherwise.
struct WallKnowledge {
  double thickness_m = 0.0, sigma_m = 0.0;  ///< of a wall that was not measured
  double crossing_sigma_m = 0.0;            ///< of a thickness measured on the way through a door
};
WallKnowledge wall_knowledge(const TopologicalMap& map, const UncertaintyConfig& config);

MapProblem map_problem(const TopologicalMap& map, const UncertaintyConfig& config);

std::optional<std::size_t> room_index(const TopologicalMap& map, RoomId room);

/// Takes poses, sizes, door positions and thicknesses over into the map. What was measured is kept beside
/// them.
void apply(const GraphSolution& solution, const MapProblem& from, TopologicalMap& map);

}  // namespace enfilade::topo_graph
