// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "components/topoGraph/core/topo_graph.hpp"

namespace enfilade::evaluate {

/// A building as a robot would model it room by room: what topoGraph gets to see, without grid or laser.
struct TrueDoor {
  std::size_t room_a = 0, room_b = 0;
  WallInterval gap_a, gap_b;
};

struct TrueBuilding {
  std::vector<Rectangle> rooms;
  std::vector<TrueDoor> doors;
};

struct StreamNoise {
  double odometry_share = 0.02;         ///< of the way between the middles of two rooms
  double odometry_yaw_rad = 0.0523599;  ///< 3° a room
  double yaw_bias_rad = 0.0;            ///< beside that, always the same way
  double centre_m = 0.01;
  double size_m = 0.015;
  double yaw_rad = 0.004;
  double gap_m = 0.02;
};

struct StreamResult {
  topo_graph::TopoState state;
  std::vector<std::vector<std::size_t>>
      modelled;            ///< by room of the map, in its order: the true rooms it stands for
  int false_closures = 0;  ///< times a true room was taken for another one, and still is
  int missed_rooms = 0;    ///< true rooms that no room of the map stands for
  int duplicates = 0;      ///< rooms of the map beyond the first for one true room
  double pose_error_max_m = 0.0;
  double pose_error_max_rad = 0.0;
};

/// Explores `building` from room 0, depth first and door by door, sending what the explorer would send.
StreamResult explore(const TrueBuilding& building, const StreamNoise& noise,
                     const topo_graph::GraphConfig& config, std::uint64_t seed);

/// A corridor in sections of `per_section` identical offices, half of them on either side.
TrueBuilding office_corridor(int offices, int per_section);
/// Rooms around a block, the last one joined to the first by a door.
TrueBuilding ring_of_rooms(int columns, int rows);

}  // namespace enfilade::evaluate
