// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/topoGraph/core/common_door.hpp"
#include "components/topoGraph/core/loop_closer.hpp"
#include "components/topoGraph/core/outcomes.hpp"
#include "components/topoGraph/core/pose_tracker.hpp"
#include "components/topoGraph/core/room_model.hpp"
#include "components/topoGraph/core/topo_state.hpp"

namespace enfilade::topo_graph {

struct RoomFixerConfig {
  CommonDoorConfig common_door;
  FaceMatchConfig face_match;
  LoopCloserConfig loop_closer;
  UncertaintyConfig uncertainty;
};

/// Puts the room of the current zone into the graph: eq. 20 against the door through which the robot came,
/// then a node (eq. 17) and its edges.
class RoomFixer {
 public:
  /// Throws std::invalid_argument where the configuration makes no sense.
  RoomFixer(const RoomFixerConfig& config, const PoseTrackerConfig& tracker);

  /// `reply.call` is left to the caller. A zone whose room is in the graph gets that room, and the room the
  /// open doors of the estimate that it does not have yet: who comes back sees what was missed.
  FixRoomOutcome fix(TopoState& state, const RoomEstimate& estimate) const;

 private:
  FixRoomOutcome add_seen_doors(TopoState& state, const Room& room, const RoomEstimate& estimate) const;
  FixRoomOutcome insert(TopoState& state, const RoomEstimate& estimate) const;
  Prediction predict(const TopoState& state, const RoomModel& model, const FixRoomOutcome& outcome) const;
  RoomLink link_to(const TopoState& state, const RoomModel& model, const FixRoomOutcome& outcome) const;
  LoopClosure closure_of(const TopoState& state, const RoomModel& model, const FixRoomOutcome& outcome) const;
  RoomId add_room(TopoState& state, const RoomModel& model, const FixRoomOutcome& outcome) const;
  void meet_common_door(TopoState& state, const RoomEstimate& estimate, FixRoomOutcome& outcome) const;
  void add_doors(TopoState& state, const RoomModel& model, FixRoomOutcome& outcome) const;
  void take_reference(Session& session, const RoomEstimate& estimate, const Room* covered) const;

  RoomFixerConfig config_;
  CommonDoorSolver common_door_;
  LoopCloser loop_closer_;
  PoseTracker tracker_;
};

}  // namespace enfilade::topo_graph
