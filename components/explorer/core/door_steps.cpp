// SPDX-License-Identifier: Apache-2.0
// Section IV, second half: with the room in the graph, choose a door and look at it closely.
#include <algorithm>
#include <cmath>
#include <utility>

#include "components/explorer/core/exploration_machine.hpp"
#include "components/explorer/core/graph_route.hpp"
#include "components/explorer/core/wording.hpp"

namespace enfilade::explorer {

void ExplorationMachine::choose_door(const Observation& seen, Decision& decision) {
  const Room* room = current_room(seen);
  if (!room) {
    if (waited_s(config_.answer_wait_s, seen)) get_stuck("the graph does not hold this room", seen, decision);
    return;
  }
  if (is_beyond_a_door(seen, decision)) return;
  const Point2 robot_map = seen.zone->T_map_zone * seen.T_zone_base->translation();
  const auto route = find_route(*seen.map, room->id, robot_map, avoid_);
  if (!route) {
    state_.target_door.reset();
    if (come_back_to_doors(seen, decision)) return;
    const auto blocked = std::count_if(seen.map->doors.begin(), seen.map->doors.end(),
                                       [](const Door& door) { return door.kind == DoorKind::kBlocked; });
    const std::string text = "no door is left: finished after " + counted(state_.sweeps_total, "sweep") +
                             (blocked > 0 ? ", " + counted(blocked, "door") + " blocked" : "");
    decision.events.push_back(text);
    return go_to(Step::kFinished, ExplorationPhase::kFinished, text, seen);
  }
  door_ = route->next;
  state_.target_door = route->target;
  const std::string via =
      route->next == route->target ? "" : " by way of door " + std::to_string(route->next);
  decision.events.push_back("door " + std::to_string(route->target) + " is next, " +
                            decimal(route->length_m, 1) + " m away" + via);
  begin_approach(seen, decision);
}

/// What barred the way may have gone, and the floor is known better than it was: doors are not called blocked
/// before they were tried again, with nothing else left to do.
bool ExplorationMachine::come_back_to_doors(const Observation& seen, Decision& decision) {
  const auto open = std::count_if(seen.map->doors.begin(), seen.map->doors.end(),
                                  [](const Door& door) { return door.kind == DoorKind::kUnresolved; });
  if (open == 0 || put_off_.empty() || door_round_ >= config_.door_rounds) return false;
  ++door_round_;
  decision.events.push_back("no other door is left: trying again what could not be reached, " +
                            counted(open, "unresolved door"));
  put_off_.clear();
  avoid_.clear();
  attempts_.clear();
  barred_.clear();
  look_behind(seen, decision);
  return true;
}

/// What barred the way and has gone is still in the grid where no sweep has been since. From one heading a
/// sweep does not show the cone behind the robot. And whoever barred it may be waiting for the robot to go.
void ExplorationMachine::look_behind(const Observation& seen, Decision& decision) {
  FloorHints known = floor_inside(seen);
  known.obstacles.insert(known.obstacles.end(), drive_.met().begin(), drive_.met().end());
  const Point2 place = place_to_give_way(seen, known).value_or(seen.T_zone_base->translation());
  const double yaw_rad = wrap_to_pi(seen.T_zone_base->yaw_rad + kPi);
  begin_look({.pose = {place.x(), place.y(), yaw_rad}}, Purpose::kLocalise, seen, decision);
  drive_.begin(*state_.goal, std::move(known));
}

/// The reachable place nearest to a step straight back from what was met on the way; nothing if nothing was.
std::optional<Point2> ExplorationMachine::place_to_give_way(const Observation& seen,
                                                            const FloorHints& known) const {
  const Point2 robot = seen.T_zone_base->translation();
  const auto& met = drive_.met();
  const auto nearest = std::min_element(met.begin(), met.end(), [&](const Point2& a, const Point2& b) {
    return (a - robot).squaredNorm() < (b - robot).squaredNorm();
  });
  if (nearest == met.end() || *nearest == robot) return std::nullopt;
  const Point2 back = robot + config_.give_way_m * (robot - *nearest).normalized();
  return drive_.ways(seen, known).usual().nearest(back, config_.give_way_m);
}

/// After a restart in the middle of a crossing the robot stands outside the room it is said to be in.
bool ExplorationMachine::is_beyond_a_door(const Observation& seen, Decision& decision) {
  constexpr double kNearM = 1.3;
  const Room& room = *current_room(seen);
  const Pose2 T_zone_room = seen.zone->T_map_zone.inverse() * room.T_map_room;
  const Point2 robot = T_zone_room.inverse() * seen.T_zone_base->translation();
  if (Rectangle{0.0, 0.0, 0.0, room.width_m, room.height_m}.contains(robot, -config_.outside_m)) return false;
  for (const Door& door : seen.map->doors) {
    const DoorFace* face = TopologicalMap::find_face(door, room.id);
    if (!face || door.kind == DoorKind::kExit || door.kind == DoorKind::kBlocked) continue;
    if ((place_door(room, *face, T_zone_room).middle - seen.T_zone_base->translation()).norm() > kNearM)
      continue;
    door_ = door.id;
    decision.events.push_back("standing outside room " + std::to_string(room.id) + ", by door " +
                              std::to_string(door.id));
    request_sent_ = false;
    go_to(Step::kEnter, ExplorationPhase::kEntering,
          "entering what lies behind door " + std::to_string(door.id), seen);
    return true;
  }
  return false;
}

std::optional<PlacedDoor> ExplorationMachine::locate_door(const Observation& seen) const {
  const Room* room = current_room(seen);
  const Door* door = seen.map ? seen.map->find_door(door_) : nullptr;
  const DoorFace* face = room && door ? TopologicalMap::find_face(*door, room->id) : nullptr;
  if (!face) return std::nullopt;
  const bool current = seen.estimate && seen.estimate->tag == *tag_;
  return place_door(*room, *face,
                    locate_room(*room, seen.zone->T_map_zone, current ? seen.estimate : nullptr, geometry_));
}

void ExplorationMachine::begin_approach(const Observation& seen, Decision& decision) {
  const auto door = locate_door(seen);
  if (!door) return go_to(Step::kChooseDoor, ExplorationPhase::kApproaching, "choosing a door", seen);
  const Point2 before = door->pose_at(-config_.staging_m).translation();
  Ways ways = drive_.ways(seen, floor_inside(seen));
  auto place = ways.usual().nearest(before, config_.staging_search_m);
  if (!place) place = ways.narrow().nearest(before, config_.staging_search_m);
  if (!place) return look_for_a_way(seen, decision);
  const Point2 way = door->middle - *place;
  const Pose2 staging{place->x(), place->y(), std::atan2(way.y(), way.x())};
  drive_.begin(staging, floor_inside(seen));
  go_to(Step::kApproach, ExplorationPhase::kApproaching, "going to door " + std::to_string(door_), seen);
  state_.goal = staging;
}

/// Of a room that it comes back to the robot knows walls and doors, but the floor only as far as it has seen
/// it this time.
void ExplorationMachine::look_for_a_way(const Observation& seen, Decision& decision) {
  const bool may_look = static_cast<int>(state_.sweeps_in_zone) < config_.max_sweeps_per_zone;
  const auto view = may_look ? next_view(seen) : std::nullopt;
  if (!view && !has_watched_) return begin_watch(Step::kChooseDoor, seen);
  if (!view) return give_up_door("there is no way to it", seen, decision);
  decision.events.push_back("door " + std::to_string(door_) + ": no way to it has been seen yet");
  begin_look(*view, Purpose::kLocalise, seen, decision);
}

void ExplorationMachine::approach(const Observation& seen, Decision& decision) {
  const DriveStatus status = drive_.update(seen, decision);
  if (status == DriveStatus::kArrived) {
    has_watched_ = false;
    begin_sweep(Purpose::kDoor, seen);
  }
  if (status == DriveStatus::kFailed) give_up_door("the way to it is barred", seen, decision);
}

void ExplorationMachine::judge(const Observation& seen, Decision& decision) {
  const auto placed = locate_door(seen);
  const Door* door = placed ? seen.map->find_door(door_) : nullptr;
  if (!door) return go_to(Step::kChooseDoor, ExplorationPhase::kApproaching, "choosing a door", seen);
  const bool current = seen.estimate && seen.estimate->tag == *tag_ && seen.estimate->found;
  const DoorEstimate* gap = current ? find_gap(*seen.estimate, *placed, geometry_) : nullptr;
  const FloorMap map =
      drive_.floor_map(seen, {.trodden = trodden_, .obstacles = {}, .passing = passing_.trail(*seen.grid)});
  const DoorJudgement judgement = judge_door(*seen.grid, map, *placed, gap, judge_config_);
  const std::string name = "door " + std::to_string(door_);
  const bool to_be_resolved = door->kind == DoorKind::kUnresolved;
  if (judgement.verdict == DoorVerdict::kExit && to_be_resolved) {
    decision.events.push_back(name + " opens on empty ground: an exit");
    return begin_mark(DoorKind::kExit, seen, decision);
  }
  const auto corridor =
      judgement.corridor ? judgement.corridor : find_corridor(map, *placed, judge_config_.corridor);
  if (!corridor && !has_watched_) return begin_watch(Step::kJudge, seen);
  if (!corridor) return give_up_door("no free way leads through it", seen, decision);
  corridor_ = *corridor;
  begin_crossing(seen, decision);
}

/// Somebody who walks to and fro leaves a trail in every sweep, as if something stood there.
void ExplorationMachine::begin_watch(Step then, const Observation& seen) {
  has_watched_ = true;
  after_watch_ = then;
  passing_.begin_watch();
  go_to(Step::kWatch, ExplorationPhase::kApproaching,
        "watching whether somebody walks before door " + std::to_string(door_), seen);
}

void ExplorationMachine::watch(const Observation& seen, Decision& decision) {
  decision.drive({});
  const bool level = seen.motor->phase == SweepPhase::kParked && seen.standing();
  if (level && seen.points) passing_.watch(*seen.T_zone_base, seen.points->points, seen.grid->resolution_m());
  if (!waited_s(config_.watch_s, seen)) return;
  passing_.end_watch();
  const bool judges = after_watch_ == Step::kJudge;
  go_to(after_watch_, ExplorationPhase::kApproaching, judges ? "judging the door" : "choosing a door", seen);
}

/// Once is chance, perhaps a person in the way: it is tried again from another view, then other doors come
/// first. A passage is never called blocked, as the robot has gone through it before.
void ExplorationMachine::give_up_door(const std::string& why, const Observation& seen, Decision& decision) {
  const int attempts = ++attempts_[door_];
  has_watched_ = false;
  decision.warnings.push_back("door " + std::to_string(door_) + ": " + why);
  if (attempts < config_.door_attempts) return look_behind(seen, decision);
  const Door* door = seen.map->find_door(door_);
  const bool last_round = door_round_ >= config_.door_rounds;
  if (last_round && door && door->kind == DoorKind::kUnresolved)
    return begin_mark(DoorKind::kBlocked, seen, decision);
  put_off_.insert(door_);
  avoid_.insert(door_);
  go_to(Step::kChooseDoor, ExplorationPhase::kApproaching, "choosing another door", seen);
}

}  // namespace enfilade::explorer
