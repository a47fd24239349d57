// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "components/topoGraph/core/outcomes.hpp"
#include "components/topoGraph/core/topo_state.hpp"

/// One line for people per event.
namespace enfilade::topo_graph {

std::string tell(const FixRoomOutcome& outcome, const TopologicalMap& map);
std::string tell(const EnterZoneOutcome& outcome, const CurrentZone& zone);
std::string tell(const MarkDoorRequest& request);
std::string tell(const ObserveOutcome& outcome, const TopologicalMap& map);
std::string tell_resumed(const TopoState& state);

}  // namespace enfilade::topo_graph
