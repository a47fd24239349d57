// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "interfaces/model/topological_map.hpp"

namespace enfilade::topo_graph {

struct MapMergeConfig {
  double size_m = 0.2;           ///< by which the sizes of a common room may differ
  double distance_m = 0.5;       ///< by which its places may, beside …
  double distance_share = 0.02;  ///< … that share of the way from the room that the maps are laid together by
  double door_m = 0.5;           ///< by which the places of a common door may differ
  double overlap_m = 0.4;        ///< by which rooms that are not common may reach into each other
  double enough = 2.0;           ///< rooms and doors met, for the best way to count at all
  double margin = 1.0;           ///< of rooms and doors, by which the best way must beat every other one
};

struct MergedMaps {
  TopologicalMap map;  ///< a, and what b adds, with new ids
  Pose2 T_a_b;
  std::vector<std::pair<RoomId, RoomId>> common;  ///< rooms of a and of b
};

/// Lays b onto a by the rooms that both hold: each pair of rooms of one size, each way round, is tried; rooms
/// and doors met count for it, doors missed and overlaps against it. b's rooms are moved as one, a's stay.
/// Throws std::invalid_argument, with a sentence, where no way or more than one makes sense.
MergedMaps merge_maps(const TopologicalMap& a, const TopologicalMap& b, const MapMergeConfig& config = {});

}  // namespace enfilade::topo_graph
