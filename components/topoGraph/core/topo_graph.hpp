// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "components/topoGraph/core/localiser.hpp"
#include "components/topoGraph/core/map_minimiser.hpp"
#include "components/topoGraph/core/outcomes.hpp"
#include "components/topoGraph/core/pose_tracker.hpp"
#include "components/topoGraph/core/room_fixer.hpp"
#include "components/topoGraph/core/topo_state.hpp"
#include "components/topoGraph/core/zone_changer.hpp"

namespace enfilade::topo_graph {

struct GraphConfig {
  RoomFixerConfig fixer;
  ZoneChangerConfig changer;
  PoseTrackerConfig tracker;
  MapMinimiserConfig minimiser;
  LocaliserConfig localiser;
  double review_unexplored_share =
      0.35;                     ///< an estimate with less unseen wall can tell that the room is another
  int review_misfits = 3;       ///< so many in a row withdraw an inferred door
  int remembered_answers = 64;  ///< calls whose answers are kept for repeats; from 1
};

/// The hybrid map of section IV: rooms, doors, the zone being modelled and, with T_map_zone, the robot's
/// place among them. Requests are idempotent by CallId. A zone's frame is its odom frame, so T_map_odom is
/// T_map_zone.
class TopoGraph {
 public:
  /// Throws std::invalid_argument where the configuration makes no sense.
  TopoGraph(const GraphConfig& config, TopoState state);

  FixRoomOutcome fix_room(const FixRoomRequest& request, StampNs now_ns);
  EnterZoneOutcome enter_zone(const EnterZoneRequest& request, StampNs now_ns);
  /// Only kExit and kBlocked can be told by looking at a door; an exit has no second room. Any door can be
  /// closed and opened.
  MarkDoorOutcome mark_door(const MarkDoorRequest& request, StampNs now_ns);
  /// Corrects T_map_zone by a new model of the room in which the robot is (eq. 18–19). While the zone's room
  /// is not in the graph there is nothing to compare with, and nothing is done.
  ObserveOutcome observe(const RoomEstimate& estimate);

  const TopoState& state() const { return state_; }
  /// Undoes what was done since `state` was taken.
  void reset_to(TopoState state) { state_ = std::move(state); }

 private:
  MarkDoorOutcome mark(const MarkDoorRequest& request);
  std::optional<PoseCorrection> locate(const RoomEstimate& estimate);
  void close_loops(FixRoomOutcome& outcome);
  void review(const RoomEstimate& estimate, ObserveOutcome& outcome);
  void confirm_door(ObserveOutcome& outcome);
  std::optional<PoseCorrection> track(const RoomEstimate& estimate);
  std::optional<PoseCorrection> find_room_again(const RoomEstimate& estimate);
  void move_zone(const Pose2& T_map_zone, PoseCorrection& correction);
  void accept(StampNs now_ns, bool changed, Answer answer);

  GraphConfig config_;
  RoomFixer fixer_;
  ZoneChanger changer_;
  PoseTracker tracker_;
  MapMinimiser minimiser_;
  Localiser localiser_;
  int misfits_ = 0;  ///< estimates in a row that are not of the room that this is taken for
  TopoState state_;
};

}  // namespace enfilade::topo_graph
