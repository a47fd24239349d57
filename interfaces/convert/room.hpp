// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <enfilade_idl/enfilade_room.h>

#include "interfaces/convert/common.hpp"
#include "interfaces/model/exploration.hpp"
#include "interfaces/model/room_diagnostics.hpp"
#include "interfaces/model/topological_map.hpp"

namespace enfilade::wire {

own::WallInterval_ to_wire(const WallInterval& interval);
/// Walls count 0 … 3.
WallInterval from_wire(const own::WallInterval_& interval);
own::RoomEstimate_ to_wire(const RoomEstimate& estimate);
RoomEstimate from_wire(const own::RoomEstimate_& estimate);
own::RoomDiagnostics_ to_wire(const RoomDiagnostics& diagnostics);
RoomDiagnostics from_wire(const own::RoomDiagnostics_& diagnostics);

own::TopologicalMap_ to_wire(const TopologicalMap& map);
TopologicalMap from_wire(const own::TopologicalMap_& map);
own::CurrentZone_ to_wire(const CurrentZone& zone);
CurrentZone from_wire(const own::CurrentZone_& zone);
own::PoseCorrection_ to_wire(const PoseCorrection& correction);
PoseCorrection from_wire(const own::PoseCorrection_& correction);
own::ExplorationState_ to_wire(const ExplorationState& state);
ExplorationState from_wire(const own::ExplorationState_& state);

}  // namespace enfilade::wire
