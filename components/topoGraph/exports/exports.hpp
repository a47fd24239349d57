// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "interfaces/model/topological_map.hpp"

/// The graph in formats of others. Coordinates are metres in the map frame.
namespace enfilade::topo_graph {

/// The chosen rooms and the doors that touch them; a door to a room left out loses that face and becomes
/// unresolved. Empty = all. Throws std::invalid_argument where there is no such room.
TopologicalMap part_of(const TopologicalMap& map, const std::vector<RoomId>& rooms);

/// RFC 7946, but for its coordinates, which are local: rooms as polygons, doors as lines between the middles
/// of their faces or, with one face, along it.
std::string to_geojson(const TopologicalMap& map);

/// Rooms as nodes, doors as edges. A door with one face leads to a node of its own, of kind "unresolved",
/// "exit" or "blocked".
std::string to_graphml(const TopologicalMap& map);

/// OGC IndoorGML 1.0 core: rooms as cells with states, passages as transitions with boundaries.
std::string to_indoorgml(const TopologicalMap& map);

}  // namespace enfilade::topo_graph
