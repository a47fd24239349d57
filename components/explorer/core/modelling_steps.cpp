// SPDX-License-Identifier: Apache-2.0
// Section IV, first half: scan, look at what is unexplored inside the estimated room, until a further sweep
// changes nothing.
#include <algorithm>
#include <cmath>

#include "components/explorer/core/exploration_machine.hpp"
#include "components/explorer/core/wording.hpp"

namespace enfilade::explorer {
namespace {

/// What may be explored where no room is known: a square round the robot.
Rectangle surroundings(const Point2& robot) {
  constexpr double kSideM = 10.0;
  return {0.0, robot.x(), robot.y(), kSideM, kSideM};
}

bool is_current(const RoomEstimate* estimate, const ZoneTag& tag) { return estimate && estimate->tag == tag; }

}  // namespace

void ExplorationMachine::begin_sweep(Purpose purpose, const Observation& seen) {
  purpose_ = purpose;
  const bool fine = purpose == Purpose::kVerify;
  sweeper_.begin(fine ? config_.fine_step_deg : config_.coarse_step_deg, seen.now_ns);
  const auto phase = fine ? ExplorationPhase::kVerifying : ExplorationPhase::kScanning;
  const std::string number = std::to_string(state_.sweeps_in_zone + 1);
  go_to(Step::kSweep, phase, "sweep " + number + (fine ? ", a fine one" : ""), seen);
}

void ExplorationMachine::sweep(const Observation& seen, Decision& decision) {
  const SweepStatus status = sweeper_.update(seen, decision);
  if (status == SweepStatus::kFailed)
    return get_stuck("the sweep motor does not finish a sweep", seen, decision);
  if (status == SweepStatus::kRunning) return;
  ++state_.sweeps_in_zone;
  ++state_.sweeps_total;
  swept_from_.push_back(*seen.T_zone_base);
  go_to(Step::kAwaitEstimate, state_.phase, "waiting for the model after the sweep", seen);
}

void ExplorationMachine::await_estimate(const Observation& seen, Decision& decision) {
  const StampNs needed_ns = sweeper_.end_ns() - 2 * sweeper_.line_period_ns();
  const bool there = is_current(seen.estimate, *tag_) && seen.estimate->stamp_ns >= needed_ns;
  if (there || waited_s(config_.estimate_wait_s, seen)) after_sweep(seen, decision);
}

void ExplorationMachine::after_sweep(const Observation& seen, Decision& decision) {
  const bool found = is_current(seen.estimate, *tag_) && seen.estimate->found;
  decision.events.push_back("sweep " + std::to_string(state_.sweeps_in_zone) +
                            " done: " + (found ? summary(*seen.estimate) : "no rectangle fits yet"));
  if (found) note_thresholds(*seen.estimate);
  if (found && purpose_ != Purpose::kDoor) note_what_was_seen(seen);
  if (purpose_ == Purpose::kLocalise && found && tell_of_new_door(seen, decision)) return;
  switch (purpose_) {
    case Purpose::kLocalise:
      return go_to(Step::kChooseDoor, ExplorationPhase::kApproaching, "choosing a door", seen);
    case Purpose::kDoor:
      return go_to(Step::kJudge, ExplorationPhase::kApproaching, "judging the door", seen);
    case Purpose::kModel:
    case Purpose::kVerify:
      break;
  }
  if (found) {
    const bool unchanged = stability_.update(*seen.estimate);
    verified_ = purpose_ == Purpose::kVerify && unchanged;
  }
  go_to(Step::kAssess, state_.phase, "weighing what was seen", seen);
}

/// An opening with a lintel leads out of the room, whatever rectangle a later sweep may favour.
void ExplorationMachine::note_thresholds(const RoomEstimate& estimate) {
  for (const DoorEstimate& door : estimate.doors) {
    if (door.state != DoorState::kOpen || !door.height_m || door.gap.width_m() > config_.widest_door_m)
      continue;
    const PlacedDoor placed{.middle = segment_of(estimate.rectangle, door.gap).midpoint(),
                            .outward = estimate.rectangle.normal(door.gap.wall),
                            .width_m = door.gap.width_m()};
    add_threshold(placed, thresholds_);
  }
}

/// Who comes back to a room may see a door that was missed when the room was fixed.
bool ExplorationMachine::tell_of_new_door(const Observation& seen, Decision& decision) {
  const Room* room = current_room(seen);
  if (!room) return false;
  const Pose2 T_zone_room = locate_room(*room, seen.zone->T_map_zone, seen.estimate, geometry_);
  if (!shows_new_door(*seen.estimate, *seen.map, *room, T_zone_room, geometry_)) return false;
  decision.events.push_back("room " + std::to_string(room->id) + " has a door that was not known");
  decision.fix_room = FixRoomRequest{.call = {}, .estimate = *seen.estimate};
  go_to(Step::kFix, ExplorationPhase::kFixing, "putting a door into the graph", seen);
  return true;
}

/// What should have been visible and is still unexplored is counted as looked at in vain.
void ExplorationMachine::note_what_was_seen(const Observation& seen) {
  const auto left = targets_.find(*seen.grid, *seen.estimate);
  for (const ViewTarget& t : views_.seen_from(*seen.grid, *seen.T_zone_base, left))
    targets_.looked_in_vain(t);
}

void ExplorationMachine::assess(const Observation& seen, Decision& decision) {
  if (!is_current(seen.estimate, *tag_) || !seen.estimate->found) return assess_without_room(seen, decision);
  const auto sweeps = static_cast<int>(state_.sweeps_in_zone);
  if (sweeps >= config_.max_sweeps_per_zone) {
    decision.events.push_back("enough sweeps: taking the room as it is known");
    return begin_fix(seen, decision);
  }
  const auto is_wide = [&](const DoorEstimate& door) {
    const double wall_m = seen.estimate->rectangle.wall_length_m(door.gap.wall);
    return door.gap.width_m() > config_.widest_door_m ||
           (wall_m > 1.0 && door.gap.width_m() > config_.whole_wall_share * wall_m);
  };
  if (const auto view = view_into_gap(seen, is_wide))
    return begin_look(*view, Purpose::kModel, seen, decision);
  if (verified_) return begin_fix(seen, decision);
  if (const auto view = next_view(seen)) return begin_look(*view, Purpose::kModel, seen, decision);
  if (sweeps == 1) {  // the cone behind the robot
    const Pose2& pose = *seen.T_zone_base;
    return begin_look({.pose = {pose.x_m, pose.y_m, wrap_to_pi(pose.yaw_rad + kPi)}}, Purpose::kModel, seen,
                      decision);
  }
  const auto is_doubtful = [&](const DoorEstimate& door) {
    return door.state == DoorState::kPossible && door.gap.width_m() >= geometry_.new_door_m;
  };
  if (const auto view = view_into_gap(seen, is_doubtful))
    return begin_look(*view, Purpose::kModel, seen, decision);
  // Nothing is left that could be seen: the finer sweep tells whether the model holds.
  begin_sweep(Purpose::kVerify, seen);
}

std::optional<View> ExplorationMachine::next_view(const Observation& seen) const {
  Ways ways = drive_.ways(seen, floor_inside(seen));
  const Reach& reach = reach_to_look(ways);
  ViewWish wish{.other_than_yaw_rad = {}, .had = swept_from_, .barred = barred_};
  if (swept_from_.size() == 1) wish.other_than_yaw_rad = swept_from_.front().yaw_rad;
  const bool found = is_current(seen.estimate, *tag_) && seen.estimate->found;
  const Rectangle area = found ? seen.estimate->rectangle : surroundings(seen.T_zone_base->translation());
  const auto worth =
      found ? targets_.find(*seen.grid, *seen.estimate) : targets_.find_floor(*seen.grid, area);
  return views_.best(*seen.grid, reach, area, worth, *seen.T_zone_base, wish);
}

/// What a gap is shows from nearby: a wall that is mostly gap may be a corridor going on, of which the end is
/// not seen yet; one that may be a door and is seen at a slant is decided from in front of it.
std::optional<View> ExplorationMachine::view_into_gap(
    const Observation& seen, const std::function<bool(const DoorEstimate&)>& is_wanted) const {
  const RoomEstimate& estimate = *seen.estimate;
  Ways ways = drive_.ways(seen, floor_inside(seen));
  const Reach& reach = reach_to_look(ways);
  for (const DoorEstimate& door : estimate.doors) {
    if (!is_wanted(door)) continue;
    const PlacedDoor gap{.middle = segment_of(estimate.rectangle, door.gap).midpoint(),
                         .outward = estimate.rectangle.normal(door.gap.wall),
                         .width_m = door.gap.width_m()};
    const auto place = reach.nearest(gap.pose_at(-config_.staging_m).translation(), config_.staging_search_m);
    if (!place || is_barred(*place, barred_)) continue;
    const Pose2 pose{place->x(), place->y(), gap.yaw_rad()};
    if (!has_looked_from(pose)) return View{.pose = pose};
  }
  return std::nullopt;
}

/// Where the robot looked from before is out of reach: what it could not see as it drove in has shut it in.
const Reach& ExplorationMachine::reach_to_look(Ways& ways) const {
  constexpr double kNearM = 0.3;
  const bool shut_in = std::any_of(swept_from_.begin(), swept_from_.end(), [&](const Pose2& had) {
    return !ways.usual().nearest(had.translation(), kNearM);
  });
  return shut_in ? ways.narrow() : ways.usual();
}

bool ExplorationMachine::has_looked_from(const Pose2& pose) const {
  return std::any_of(swept_from_.begin(), swept_from_.end(), [&](const Pose2& had) {
    return (had.translation() - pose.translation()).norm() < 1.0 &&
           std::abs(wrap_to_pi(had.yaw_rad - pose.yaw_rad)) < radians(70.0);
  });
}

void ExplorationMachine::assess_without_room(const Observation& seen, Decision& decision) {
  const auto sweeps = static_cast<int>(state_.sweeps_in_zone);
  if (sweeps >= config_.looks_without_room) {
    return get_stuck("no rectangle fits what is seen in zone " + std::to_string(tag_->zone_id) + " after " +
                         counted(sweeps, "sweep"),
                     seen, decision);
  }
  const Pose2& pose = *seen.T_zone_base;
  const View turned{.pose = {pose.x_m, pose.y_m, wrap_to_pi(pose.yaw_rad + (sweeps == 1 ? kPi : 0.5 * kPi))}};
  begin_look(sweeps == 1 ? turned : next_view(seen).value_or(turned), Purpose::kModel, seen, decision);
}

void ExplorationMachine::begin_look(const View& view, Purpose purpose, const Observation& seen,
                                    Decision& decision) {
  const std::string activity =
      "looking from " + place_of(view.pose.translation()) + " towards the " + compass(view.pose.yaw_rad);
  decision.events.push_back(activity);
  purpose_ = purpose;
  drive_.begin(view.pose, floor_inside(seen));
  go_to(Step::kLook, ExplorationPhase::kLooking, activity, seen);
  state_.goal = view.pose;
}

void ExplorationMachine::look(const Observation& seen, Decision& decision) {
  const DriveStatus status = drive_.update(seen, decision);
  if (status == DriveStatus::kDriving) return;
  if (status == DriveStatus::kFailed) {
    decision.warnings.push_back("cannot get there: looking from here");
    const Point2 goal = state_.goal->translation();
    if (!is_barred(seen.T_zone_base->translation(), {goal})) barred_.push_back(goal);
  }
  begin_sweep(purpose_, seen);
}

void ExplorationMachine::begin_fix(const Observation& seen, Decision& decision) {
  decision.events.push_back("the room is " + std::string(verified_ ? "stable" : "not stable") + ", " +
                            size_of(seen.estimate->rectangle) + ": fixing it");
  decision.fix_room = FixRoomRequest{.call = {}, .estimate = *seen.estimate};
  go_to(Step::kFix, ExplorationPhase::kFixing, "putting the room into the graph", seen);
}

void ExplorationMachine::fix(const Observation& seen, Decision& decision) {
  if (!seen.fixed) return;  // asked again until answered
  if (seen.fixed->accepted) {
    decision.events.push_back("this is room " + std::to_string(seen.fixed->room));
    return go_to(Step::kAwaitRoom, ExplorationPhase::kFixing, "waiting for the room in the graph", seen);
  }
  decision.warnings.push_back("the room was refused: " + seen.fixed->message);
  verified_ = false;
  if (static_cast<int>(state_.sweeps_in_zone) < config_.max_sweeps_per_zone)
    return begin_sweep(Purpose::kModel, seen);
  get_stuck("the room cannot be fixed: " + seen.fixed->message, seen, decision);
}

void ExplorationMachine::await_room(const Observation& seen) {
  if (current_room(seen))
    return go_to(Step::kChooseDoor, ExplorationPhase::kApproaching, "choosing a door", seen);
  // The answer came, but neither zone nor map: they are latched and will be there when topoGraph is.
  if (waited_s(config_.answer_wait_s, seen)) begin_sweep(Purpose::kModel, seen);
}

}  // namespace enfilade::explorer
