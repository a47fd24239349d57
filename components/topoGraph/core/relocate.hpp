// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "interfaces/model/topological_map.hpp"

namespace enfilade::topo_graph {

/// T_map_zone that lays the estimate's rectangle on a stored room, however the zone frame has jumped (the
/// odometry was restarted). Of the poses that a rectangle's symmetry allows, the one under which most open
/// gaps fall on the room's doors; among equals the one that turns the zone frame least. Nothing where the
/// sizes do not agree.
std::optional<Pose2> relocate(const TopologicalMap& map, const Room& room, const RoomEstimate& estimate,
                              const Pose2& T_map_zone_before, double max_size_difference_m);

}  // namespace enfilade::topo_graph
