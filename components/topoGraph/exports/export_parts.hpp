// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "interfaces/model/topological_map.hpp"

/// What the exporters share.
namespace enfilade::topo_graph::exports {

std::string_view kind_name(DoorKind kind);
std::string room_name(const Room& room);
/// Counter-clockwise, not closed, map frame.
std::vector<Point2> outline(const Room& room);
Point2 middle(const TopologicalMap& map, const DoorFace& face);
/// The text with what XML does not allow escaped or, where XML knows no way to write it, replaced by "?".
std::string xml(std::string_view text);
/// From one room's middle through the door to the other's.
double walk_m(const TopologicalMap& map, const Door& door);

}  // namespace enfilade::topo_graph::exports
