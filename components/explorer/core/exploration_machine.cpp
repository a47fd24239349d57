// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/exploration_machine.hpp"

#include <stdexcept>
#include <utility>

#include "components/explorer/core/wording.hpp"

namespace enfilade::explorer {
namespace {

constexpr double kTreadEveryM = 0.10;

const ExplorationConfig& checked(const ExplorationConfig& c) {
  if (!(c.coarse_step_deg > 0.0 && c.fine_step_deg > 0.0)) {
    throw std::invalid_argument("exploration: coarse_step_deg and fine_step_deg must be greater than 0");
  }
  if (c.max_sweeps_per_zone < 2)
    throw std::invalid_argument("exploration: max_sweeps_per_zone must be at least 2");
  return c;
}

}  // namespace

ExplorationMachine::ExplorationMachine(const MachineConfig& config)
    : config_(checked(config.exploration)),
      geometry_(config.geometry),
      judge_config_(config.judge),
      sweeper_(config.sweeper),
      stability_(config.stability),
      targets_(config.targets),
      views_(config.views),
      drive_(config.drive),
      crossing_(config.crossing, config.drive.guard) {
  state_.activity = "waiting for a zone, a grid and the odometry";
}

Decision ExplorationMachine::update(const Observation& seen) {
  Decision decision;
  if (step_ != Step::kWait && world_has_changed(seen)) {
    go_to(Step::kWait, ExplorationPhase::kWaiting, "waiting for the grid of the zone", seen);
    decision.drive({});
  }
  if (step_ == Step::kWait) {
    if (world_is_ready(seen)) start_zone(seen, decision);
    return decision;
  }
  tread(seen);
  step(seen, decision);
  state_.room = seen.zone->room;
  if (seen.estimate) state_.unexplored_wall_share = seen.estimate->unexplored_wall_share;
  return decision;
}

bool ExplorationMachine::world_is_ready(const Observation& seen) const {
  return seen.zone && seen.motor && seen.T_zone_base && seen.grid && seen.grid_tag &&
         seen.grid_tag->zone_id == seen.zone->zone_id && seen.grid_tag->odom_boot == seen.motor->odom_boot;
}

bool ExplorationMachine::world_has_changed(const Observation& seen) const {
  return seen.zone->zone_id != tag_->zone_id || seen.motor->odom_boot != tag_->odom_boot ||
         seen.grid_tag != tag_;
}

void ExplorationMachine::step(const Observation& seen, Decision& decision) {
  switch (step_) {
    case Step::kWait:
      return;
    case Step::kSweep:
      return sweep(seen, decision);
    case Step::kAwaitEstimate:
      return await_estimate(seen, decision);
    case Step::kAssess:
      return assess(seen, decision);
    case Step::kLook:
      return look(seen, decision);
    case Step::kFix:
      return fix(seen, decision);
    case Step::kAwaitRoom:
      return await_room(seen);
    case Step::kChooseDoor:
      return choose_door(seen, decision);
    case Step::kApproach:
      return approach(seen, decision);
    case Step::kJudge:
      return judge(seen, decision);
    case Step::kWatch:
      return watch(seen, decision);
    case Step::kAlign:
      return align(seen, decision);
    case Step::kCross:
      return cross(seen, decision);
    case Step::kBackOff:
      return back_off(seen, decision);
    case Step::kMark:
      return mark(seen, decision);
    case Step::kEnter:
      return enter(seen, decision);
    case Step::kAwaitZone:
      return await_zone(seen, decision);
    case Step::kFinished:
      return;
    case Step::kStuck:
      if (waited_s(config_.retry_s, seen)) start_zone(seen, decision);
      return;
  }
}

/// A new space, or the same one with a grid that begins anew.
void ExplorationMachine::start_zone(const Observation& seen, Decision& decision) {
  const bool new_zone = !tag_ || tag_->zone_id != seen.zone->zone_id;
  tag_ = seen.grid_tag;
  state_.sweeps_in_zone = 0;
  state_.unexplored_wall_share = 1.0;
  state_.target_door.reset();
  stability_.reset();
  targets_.reset();
  trodden_.clear();
  thresholds_.clear();
  swept_from_.clear();
  barred_.clear();
  passing_.clear();
  verified_ = false;
  if (new_zone) attempts_.clear();
  if (seen.zone->room) {
    decision.events.push_back("in room " + std::to_string(*seen.zone->room) +
                              ": scanning it to see where the robot is");
    begin_sweep(Purpose::kLocalise, seen);
  } else {
    decision.events.push_back("zone " + std::to_string(seen.zone->zone_id) + ": a new space to model");
    begin_sweep(Purpose::kModel, seen);
  }
}

void ExplorationMachine::go_to(Step step, ExplorationPhase phase, std::string activity,
                               const Observation& seen) {
  step_ = step;
  step_since_ns_ = seen.now_ns;
  state_.phase = phase;
  state_.activity = std::move(activity);
  state_.goal.reset();
}

/// The floor under the robot is free.
void ExplorationMachine::tread(const Observation& seen) {
  const Point2 here = seen.T_zone_base->translation();
  if (trodden_.empty() || (trodden_.back() - here).norm() > kTreadEveryM) trodden_.push_back(here);
}

/// The floor for ways inside the room: doors are gone through by crossing them, never on the way elsewhere.
FloorHints ExplorationMachine::floor_inside(const Observation& seen) const {
  FloorHints known{.trodden = trodden_, .obstacles = thresholds_, .passing = passing_.trail(*seen.grid)};
  const Room* room = current_room(seen);
  if (!room) return known;
  const RoomEstimate* estimate = seen.estimate && seen.estimate->tag == *tag_ ? seen.estimate : nullptr;
  const Pose2 T_zone_room = locate_room(*room, seen.zone->T_map_zone, estimate, geometry_);
  for (const Door& door : seen.map->doors) {
    const DoorFace* face = TopologicalMap::find_face(door, room->id);
    if (face) add_threshold(place_door(*room, *face, T_zone_room), known.obstacles);
  }
  return known;
}

void ExplorationMachine::get_stuck(const std::string& why, const Observation& seen, Decision& decision) {
  decision.warnings.push_back("stuck: " + why);
  go_to(Step::kStuck, ExplorationPhase::kStuck, why, seen);
}

const Room* ExplorationMachine::current_room(const Observation& seen) const {
  return seen.map && seen.zone->room ? seen.map->find_room(*seen.zone->room) : nullptr;
}

}  // namespace enfilade::explorer
