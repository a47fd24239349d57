// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "components/topoGraph/core/optimise/graph_problem.hpp"

namespace enfilade::topo_graph {

/// The rooms' poses chained from room 0 over the most certain edges (Dijkstra). A loop door takes part only
/// where the edges that the robot travelled, or loop doors that passed before, lead to the same relative pose
/// within their uncertainty: one wrong door in the tree would displace all that hangs on it. A room that
/// nothing leads to keeps the pose it has.
std::vector<Pose2> tree_poses(const GraphProblem& problem);

}  // namespace enfilade::topo_graph
