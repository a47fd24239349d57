// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/topoGraph/core/topo_state.hpp"
#include "components/topoGraph/storage/yaml_reader.hpp"

/// The parts of a map file and of its journal, read strictly: MapFileError names the line. What refers to
/// rooms and doors of `graph` is looked up there; without one that is left for later.
namespace enfilade::topo_graph {

Pose2 read_pose(const YamlValue& value);
double read_size(const YamlValue& value);
double read_sigma(const YamlValue& value);
Rectangle read_rectangle(const YamlValue& value);
WallInterval read_gap(const YamlValue& value);

Room read_room(const YamlValue& value);
Door read_door(const YamlValue& value, const TopologicalMap* graph);
RoomId read_known_room(const YamlValue& value, const TopologicalMap* graph);
RoomLink read_link(const YamlValue& value, const TopologicalMap* graph);
Place read_place(const YamlValue& value);
Session read_session(const YamlValue& value, const TopologicalMap* graph);

}  // namespace enfilade::topo_graph
