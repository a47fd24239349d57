// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "components/explorer/core/observation.hpp"
#include "components/explorer/core/path_follower.hpp"
#include "components/explorer/core/safety_guard.hpp"
#include "components/explorer/core/ways.hpp"

namespace enfilade::explorer {

struct DriveConfig {
  FloorMapConfig floor;
  PathPlannerConfig planner;
  PathFollowerConfig follower;
  SafetyGuardConfig guard;
  double near_clearance_m = 0.28;  ///< so close to obstacles …
  double near_speed_m_s = 0.20;    ///< … it goes this slowly, and faster the more room there is
  double narrow_speed_m_s = 0.10;  ///< instead, on a way that keeps only narrow_radius_m
  double open_clearance_m = 0.50;
  double blocked_s = 2.0;   ///< stands this long before something in the way before it looks for another way
  double patience_s = 6.0;  ///< and this long where there is none
  int max_replans = 3;
  double slowest_m_s = 0.05;  ///< slower than this on the whole, it has failed
  double spare_s = 40.0;
};

enum class DriveStatus { kDriving, kArrived, kFailed };

/// Drives to a pose over known free floor, stopping for what stands in the way.
class Drive {
 public:
  explicit Drive(const DriveConfig& config);

  /// The floor as it is known now, from the grid and otherwise.
  FloorMap floor_map(const Observation& seen, const FloorHints& known) const;
  /// What can be reached from where the robot is.
  Ways ways(const Observation& seen, const FloorHints& known) const;

  void begin(const Pose2& goal, FloorHints known);
  DriveStatus update(const Observation& seen, Decision& decision);
  /// Seen in the way since begin(), zone frame.
  const std::vector<Point2>& met() const { return met_; }

 private:
  bool plan(const Observation& seen);
  std::optional<Path> find_path(const Observation& seen);
  DriveStatus wait_blocked(const Observation& seen, const std::vector<Point2>& in_the_way);
  void go_on();
  double speed_limit_m_s(const Point2& at) const;

  DriveConfig config_;
  PathFollower follower_;
  SafetyGuard guard_;
  Pose2 goal_;
  FloorHints known_;
  std::vector<Point2> met_;
  std::optional<FloorMap> map_;
  bool narrow_ = false;  ///< no way keeps the usual distance from obstacles
  std::optional<StampNs> blocked_since_ns_;
  bool no_way_round_ = false;  ///< what is in the way now
  StampNs deadline_ns_ = 0;
  int replans_ = 0;
};

}  // namespace enfilade::explorer
