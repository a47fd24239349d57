// SPDX-License-Identifier: Apache-2.0
// The change of room: through the door, centred and square to it, and then the protocol with topoGraph.
#include "components/explorer/core/exploration_machine.hpp"

namespace enfilade::explorer {
namespace {

std::string to_string(DoorKind kind) { return kind == DoorKind::kExit ? "an exit" : "blocked"; }

}  // namespace

void ExplorationMachine::begin_crossing(const Observation& seen, Decision& decision) {
  decision.events.push_back("crossing door " + std::to_string(door_));
  drive_.begin(corridor_.from, floor_inside(seen));
  go_to(Step::kAlign, ExplorationPhase::kApproaching, "lining up with door " + std::to_string(door_), seen);
  state_.goal = corridor_.from;
}

void ExplorationMachine::align(const Observation& seen, Decision& decision) {
  const DriveStatus status = drive_.update(seen, decision);
  if (status == DriveStatus::kFailed) return give_up_door("cannot line up with it", seen, decision);
  if (status == DriveStatus::kDriving) return;
  crossing_.begin(corridor_, false, seen.now_ns);
  go_to(Step::kCross, ExplorationPhase::kCrossing, "going through door " + std::to_string(door_), seen);
  state_.goal = corridor_.to;
}

void ExplorationMachine::cross(const Observation& seen, Decision& decision) {
  const CrossingStatus status = crossing_.update(seen, decision);
  if (status == CrossingStatus::kDone) {
    request_sent_ = false;
    return go_to(Step::kEnter, ExplorationPhase::kEntering,
                 "entering what lies behind door " + std::to_string(door_), seen);
  }
  if (status == CrossingStatus::kBlocked) {
    decision.warnings.push_back("door " + std::to_string(door_) +
                                ": something stands in the way, going back");
    crossing_.begin(corridor_, true, seen.now_ns);
    go_to(Step::kBackOff, ExplorationPhase::kCrossing, "going back from door " + std::to_string(door_), seen);
  }
}

void ExplorationMachine::back_off(const Observation& seen, Decision& decision) {
  const CrossingStatus status = crossing_.update(seen, decision);
  if (status == CrossingStatus::kUnderWay) return;
  if (status == CrossingStatus::kBlocked)
    return get_stuck("shut in at door " + std::to_string(door_), seen, decision);
  give_up_door("it cannot be crossed", seen, decision);
}

void ExplorationMachine::begin_mark(DoorKind kind, const Observation& seen, Decision& decision) {
  verdict_ = kind;
  decision.mark_door = MarkDoorRequest{.call = {}, .door = door_, .kind = kind};
  go_to(Step::kMark, ExplorationPhase::kApproaching,
        "door " + std::to_string(door_) + " is " + to_string(kind), seen);
}

void ExplorationMachine::mark(const Observation& seen, Decision& decision) {
  if (!seen.marked) return;  // asked again until answered
  if (!seen.marked->accepted) {
    decision.warnings.push_back("door " + std::to_string(door_) +
                                " could not be marked: " + seen.marked->message);
  }
  avoid_.insert(door_);  // the map may come later than the answer
  go_to(Step::kChooseDoor, ExplorationPhase::kApproaching, "choosing a door", seen);
}

void ExplorationMachine::enter(const Observation& seen, Decision& decision) {
  decision.drive({});
  if (!request_sent_) {
    if (!seen.standing()) return;
    request_sent_ = true;
    decision.enter_zone = EnterZoneRequest{.call = {},
                                           .from_room = *seen.zone->room,
                                           .via_door = door_,
                                           .T_zone_base = *seen.T_zone_base,
                                           .stamp_ns = seen.pose_stamp_ns};
    return;
  }
  if (!seen.entered) return;  // asked again until answered
  if (seen.entered->accepted) {
    decision.events.push_back("through door " + std::to_string(door_) + ": zone " +
                              std::to_string(seen.entered->zone_id));
    return go_to(Step::kAwaitZone, ExplorationPhase::kEntering, "waiting for the new zone", seen);
  }
  get_stuck("the new zone was refused: " + seen.entered->message, seen, decision);
}

/// The new zone starts everything again (world_has_changed).
void ExplorationMachine::await_zone(const Observation& seen, Decision& decision) {
  if (waited_s(config_.answer_wait_s, seen))
    get_stuck("the new zone was promised and does not come", seen, decision);
}

}  // namespace enfilade::explorer
