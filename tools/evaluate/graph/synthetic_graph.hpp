// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "components/topoGraph/core/optimise/graph_problem.hpp"

/// Graphs of rooms with known truth and honest noise.
namespace enfilade::evaluate {

enum class Building : std::uint8_t {
  kGrid,      ///< rows of rooms, driven up and down; further doors between neighbours are loops
  kRing,      ///< rooms along the edge of a block, closed by one loop door
  kCorridor,  ///< sections of a corridor with an office on either side; doors between offices are loops
};

struct GraphNoise {
  double odometry_share = 0.02;         ///< of the way from room to room, σ of each coordinate
  double odometry_yaw_rad = 0.0523599;  ///< 3° a room
  double size_m = 0.01;
  double offset_m = 0.02;
  double direction_rad = 0.0087266;  ///< 0.5°
  double thickness_m = 0.05;         ///< spread of the walls about 0.15 m
  double crooked_rad = 0.005;        ///< by which the true rooms miss being parallel
};

struct SyntheticSpec {
  Building building = Building::kGrid;
  int rooms = 100;
  int loops = 40;       ///< at most; a ring has one
  int false_doors = 0;  ///< loop doors between rooms that no door joins; half of them near by
  std::uint64_t seed = 1;
  GraphNoise noise;
};

struct SyntheticGraph {
  topo_graph::GraphProblem problem;  ///< measured; the rooms' poses are those of raw odometry
  std::vector<topo_graph::RoomNode> truth;
  int loops = 0;
};

/// The number of rooms may come out a little smaller, where the building's shape asks for it.
SyntheticGraph make_graph(const SyntheticSpec& spec);

/// √ of the mean squared distance of the rooms' centres from the truth. Room 0 is fixed, nothing is aligned.
double position_rmse_m(const std::vector<topo_graph::RoomNode>& rooms,
                       const std::vector<topo_graph::RoomNode>& truth);

}  // namespace enfilade::evaluate
