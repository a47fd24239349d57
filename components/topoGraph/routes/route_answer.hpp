// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interfaces/model/requests.hpp"

namespace enfilade::topo_graph {

/// The route asked for, or why there is none.
RouteReply answer_route(const TopologicalMap& map, const RouteRequest& request);

}  // namespace enfilade::topo_graph
