// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "components/topoGraph/merge/map_merge.hpp"

namespace enfilade::topo_graph {

/// A room of b that is a room of a. The frame of b's room is that of a's, turned by `turns` quarters.
struct CommonRoom {
  std::size_t in_a = 0, in_b = 0;  ///< indices
  int turns = 0;
};

struct MapAlignment {
  Pose2 T_a_b;
  std::vector<CommonRoom> common;
  double score = 0.0;
};

/// See merge_maps().
MapAlignment align_maps(const TopologicalMap& a, const TopologicalMap& b, const MapMergeConfig& config);

/// How far two rectangles reach into each other; negative where they do not.
double depth_of_overlap(const Rectangle& a, const Rectangle& b);

}  // namespace enfilade::topo_graph
