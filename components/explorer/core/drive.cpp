// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/drive.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace enfilade::explorer {

Drive::Drive(const DriveConfig& config) : config_(config), follower_(config.follower), guard_(config.guard) {
  if (!(config.planner.soft_radius_m > config.planner.hard_radius_m)) {
    throw std::invalid_argument("Drive: soft_radius_m must be above hard_radius_m");
  }
  if (config.planner.narrow_radius_m < config.guard.robot_radius_m + config.guard.side_margin_m) {
    throw std::invalid_argument("Drive: narrow_radius_m must be at least robot_radius_m + side_margin_m");
  }
}

FloorMap Drive::floor_map(const Observation& seen, const FloorHints& known) const {
  FloorHints hints = known;
  hints.obstacles.insert(hints.obstacles.end(), met_.begin(), met_.end());
  if (seen.T_zone_base) hints.trodden.push_back(seen.T_zone_base->translation());
  return FloorMap(*seen.grid, hints, config_.floor);
}

Ways Drive::ways(const Observation& seen, const FloorHints& known) const {
  return Ways(floor_map(seen, known), config_.planner, seen.T_zone_base->translation());
}

void Drive::begin(const Pose2& goal, FloorHints known) {
  goal_ = goal;
  known_ = std::move(known);
  met_.clear();
  map_.reset();
  blocked_since_ns_.reset();
  no_way_round_ = false;
  replans_ = 0;
}

bool Drive::plan(const Observation& seen) {
  const Pose2& pose = *seen.T_zone_base;
  map_ = floor_map(seen, known_);
  narrow_ = false;
  double length_m = (goal_.translation() - pose.translation()).norm();
  std::vector<Point2> points{pose.translation(), goal_.translation()};
  if (length_m < config_.follower.goal_tolerance_m) {
    points.clear();  // only the heading is left
  } else {
    const auto path = find_path(seen);
    if (!path) return false;
    points = path->points;
    length_m = path->length_m;
  }
  follower_.follow(std::move(points), goal_.yaw_rad);
  deadline_ns_ = seen.now_ns + from_seconds(config_.spare_s + length_m / config_.slowest_m_s);
  return true;
}

std::optional<Path> Drive::find_path(const Observation& seen) {
  Ways ways(*map_, config_.planner, seen.T_zone_base->translation());
  if (auto path = ways.usual().path_to(goal_.translation())) return path;
  narrow_ = true;
  return ways.narrow().path_to(goal_.translation());
}

DriveStatus Drive::update(const Observation& seen, Decision& decision) {
  decision.drive({});
  if (!map_ && !plan(seen)) return DriveStatus::kFailed;
  if (seen.now_ns > deadline_ns_) return DriveStatus::kFailed;
  if (seen.motor->phase != SweepPhase::kParked)
    return DriveStatus::kDriving;  // the guard needs a level scan plane
  const PathFollower::Step step =
      follower_.update(*seen.T_zone_base, speed_limit_m_s(seen.T_zone_base->translation()));
  if (step.done) return DriveStatus::kArrived;
  const auto in_the_way =
      seen.points ? guard_.in_the_way(step.velocity, seen.points->points) : std::vector<Point2>{};
  if (!in_the_way.empty()) return wait_blocked(seen, in_the_way);
  go_on();
  decision.drive(step.velocity);
  return DriveStatus::kDriving;
}

/// After a while it looks for a way round; where there is none, whoever bars the way may go yet.
DriveStatus Drive::wait_blocked(const Observation& seen, const std::vector<Point2>& in_the_way) {
  if (!blocked_since_ns_) blocked_since_ns_ = seen.now_ns;
  const double waited_s = seconds(seen.now_ns - *blocked_since_ns_);
  if (waited_s < config_.blocked_s) return DriveStatus::kDriving;
  if (no_way_round_) return waited_s < config_.patience_s ? DriveStatus::kDriving : DriveStatus::kFailed;
  for (const Point2& p : in_the_way) met_.push_back(*seen.T_zone_base * p);
  if (++replans_ > config_.max_replans) return DriveStatus::kFailed;
  const bool was_narrow = narrow_;
  if (plan(seen)) {
    blocked_since_ns_.reset();
  } else {
    no_way_round_ = true;
    narrow_ = was_narrow;
  }
  return DriveStatus::kDriving;
}

/// What was met has gone, and is no obstacle any more.
void Drive::go_on() {
  if (no_way_round_) met_.clear();
  no_way_round_ = false;
  blocked_since_ns_.reset();
}

double Drive::speed_limit_m_s(const Point2& at) const {
  const double room_m = map_->to_obstacle_m(map_->cell_at(at)) - config_.near_clearance_m;
  const double share = std::clamp(room_m / (config_.open_clearance_m - config_.near_clearance_m), 0.0, 1.0);
  const double near_m_s = narrow_ ? config_.narrow_speed_m_s : config_.near_speed_m_s;
  return near_m_s + share * (config_.follower.linear_m_s - near_m_s);
}

}  // namespace enfilade::explorer
