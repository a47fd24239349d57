// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>

#include "interfaces/model/topological_map.hpp"

namespace enfilade::explorer {

/// The way to a door that nobody has looked behind.
struct DoorRoute {
  DoorId next = 0;    ///< the door to go to in the present room
  DoorId target = 0;  ///< the unresolved door; the same where it is in this room
  double length_m = 0.0;
};

/// The nearest unresolved door over the graph: door to door across rooms (Dijkstra), through passages.
/// `avoid` and doors marked closed are not used, neither as target nor on the way. Nothing where no such door
/// is left.
std::optional<DoorRoute> find_route(const TopologicalMap& map, RoomId room, const Point2& robot_map,
                                    const std::set<DoorId>& avoid);

}  // namespace enfilade::explorer
