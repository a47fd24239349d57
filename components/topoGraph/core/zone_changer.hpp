// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/topoGraph/core/outcomes.hpp"
#include "components/topoGraph/core/placed_face.hpp"
#include "components/topoGraph/core/topo_state.hpp"

namespace enfilade::topo_graph {

struct ZoneChangerConfig {
  FaceMatchConfig face_match;
  double inside_room_m = 0.2;  ///< so far inside a stored room the robot is taken to have entered it
};

/// Issues the next zone when the robot has gone through a door, and tells whether a room lies there that the
/// graph holds.
class ZoneChanger {
 public:
  /// Throws std::invalid_argument where the configuration makes no sense.
  explicit ZoneChanger(const ZoneChangerConfig& config);

  /// `reply.call` is left to the caller.
  EnterZoneOutcome enter(TopoState& state, const EnterZoneRequest& request) const;

 private:
  std::optional<RoomId> room_behind(TopoState& state, const EnterZoneRequest& request,
                                    EnterZoneOutcome& outcome) const;

  ZoneChangerConfig config_;
};

}  // namespace enfilade::topo_graph
