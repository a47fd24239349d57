// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "interfaces/model/topological_map.hpp"

namespace enfilade::topo_graph {

/// A room as the graph will hold it, with the doors that its walls show. `quarter_turns` as in
/// CanonicalRectangle: wall i of the estimate is wall i + quarter_turns of the room.
struct RoomModel {
  Room room;                        ///< id and name not yet given
  std::vector<DoorEstimate> doors;  ///< open ones only, gaps named as the room's walls
  int quarter_turns = 0;
};

/// Eq. 17: T_map_room is the pose of the estimate's rectangle, its sides named so that the yaw in the map
/// frame lies in
/// [-π/4, π/4): the name of a wall then does not depend on how the zone frame happened to lie.
RoomModel room_model(const RoomEstimate& estimate, const Pose2& T_map_zone);

/// The same gap after the walls were renamed.
WallInterval renamed(WallInterval gap, int quarter_turns);

}  // namespace enfilade::topo_graph
