// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "components/topoGraph/storage/map_change.hpp"
#include "components/topoGraph/storage/yaml_reader.hpp"

namespace enfilade::topo_graph {

/// YAML in the words of the map file: parse_change(to_yaml(x), …) == x.
std::string to_yaml(const MapChange& change);

/// Strict, but for what refers to rooms and doors of the map. Throws MapFileError.
MapChange parse_change(const std::string& text, const YamlSource& source);

}  // namespace enfilade::topo_graph
