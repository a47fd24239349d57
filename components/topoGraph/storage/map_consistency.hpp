// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "components/topoGraph/storage/map_file.hpp"

namespace enfilade::topo_graph {

/// Why there cannot be such a face in this map: its room is not there, or its gap not on the wall.
std::optional<std::string> problem_of(const DoorFace& face, const TopologicalMap& map);

/// Why these rooms, doors and session cannot belong together, though each of them is sound: the first thing
/// for which parse_map_file() would refuse to_yaml(file).
std::optional<std::string> find_contradiction(const MapFile& file);

}  // namespace enfilade::topo_graph
