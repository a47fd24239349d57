// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "interfaces/bus/bus.hpp"
#include "interfaces/model/exploration.hpp"
#include "interfaces/model/grid.hpp"
#include "interfaces/model/health.hpp"
#include "interfaces/model/sensing.hpp"
#include "interfaces/model/simulation.hpp"
#include "tools/draw/figures.hpp"

namespace enfilade::report {

/// What a run came to, in the map's frame.
struct RunRecord {
  TopologicalMap map;
  ExplorationState exploration;
  GroundTruth ground_truth;       ///< the last one
  double pose_error_max_m = 0.0;  ///< largest distance of the robot from where it believed to be
  std::map<std::uint32_t, std::vector<draw::ScanFigure>>
      scans;  ///< by zone, of zones whose room was not in the graph yet

  StampNs stuck_since_ns = 0;  ///< 0 = is not stuck
  std::uint32_t sweeps = 0;

  /// Nothing more will happen: the explorer is done, or has been stuck for longer than it takes to try again.
  bool ended() const;
  /// The explorer is done, and no door was left without an answer.
  bool finished() const;
};

/// Listens to a run, on whichever bus, and keeps what a report needs. A tool: it may read the ground truth.
class RunRecorder {
 public:
  /// `T_world_start`: where odom and map started in the world, for the pose error.
  RunRecorder(Bus& bus, const Pose2& T_world_start);
  RunRecorder(const RunRecorder&) = delete;
  RunRecorder& operator=(const RunRecorder&) = delete;

  const RunRecord& record() const { return record_; }

 private:
  void take_exploration(const ExplorationState& state);
  void take_hits(const ScanHits& hits);
  void take_zone(const CurrentZone& zone);
  void take_transforms(const TransformList& list);
  void take_ground_truth(const GroundTruth& truth);
  void take_odometry(const Odometry& odometry);
  void compare_poses();
  void take_estimate(const RoomEstimate& estimate);
  void keep_scan();

  RunRecord record_;
  Pose2 T_world_start_;
  std::optional<CurrentZone> zone_;
  std::optional<RoomEstimate> estimate_;
  bool scan_pending_ = false;  ///< a sweep is over whose estimate has not come yet
  StampNs last_hits_ns_ = 0;
  std::optional<Odometry> odometry_;
  Pose2 T_map_odom_;
  Pose2 T_zone_base_;
  ZoneTag points_tag_;
  std::vector<Point2> points_;
};

}  // namespace enfilade::report
