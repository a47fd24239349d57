// SPDX-License-Identifier: Apache-2.0
#include "tools/report/run_recorder.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "interfaces/topics/topics.hpp"

namespace enfilade::report {
namespace {

constexpr float kAboveFloor_m = 0.15F;
constexpr float kBelowCeiling_m = 2.5F;
constexpr std::size_t kMaxPoints = 400'000;

constexpr double kStuckForGood_s = 65.0;  // three times the explorer's own wait before it tries again

}  // namespace

bool RunRecord::ended() const {
  const bool is_stuck =
      stuck_since_ns > 0 && seconds(exploration.stamp_ns - stuck_since_ns) > kStuckForGood_s;
  return exploration.phase == ExplorationPhase::kFinished || is_stuck;
}

bool RunRecord::finished() const {
  const auto is_open = [](const Door& door) { return door.kind == DoorKind::kUnresolved; };
  return exploration.phase == ExplorationPhase::kFinished &&
         std::none_of(map.doors.begin(), map.doors.end(), is_open);
}

RunRecorder::RunRecorder(Bus& bus, const Pose2& T_world_start) : T_world_start_(T_world_start) {
  bus.subscribe<TopologicalMap>(topics::kTopologicalMap, [this](const auto& map) { record_.map = map; });
  bus.subscribe<RoomEstimate>(topics::kRoomEstimate,
                              [this](const auto& estimate) { take_estimate(estimate); });
  bus.subscribe<Odometry>(topics::kOdom, [this](const auto& odometry) { take_odometry(odometry); });
  bus.subscribe<TransformList>(topics::kTf, [this](const auto& list) { take_transforms(list); });
  bus.subscribe<CurrentZone>(topics::kCurrentZone, [this](const auto& zone) { take_zone(zone); });
  bus.subscribe<ScanHits>(topics::kScanHits, [this](const auto& hits) { take_hits(hits); });
  bus.subscribe<ExplorationState>(topics::kExplorationState,
                                  [this](const auto& state) { take_exploration(state); });
  bus.subscribe<GroundTruth>(topics::kGroundTruth, [this](const auto& truth) { take_ground_truth(truth); });
}

void RunRecorder::take_zone(const CurrentZone& zone) { zone_ = zone; }

void RunRecorder::take_transforms(const TransformList& list) {
  if (const auto told = find_transform(list, "map", "odom")) T_map_odom_ = *told;
}

void RunRecorder::take_hits(const ScanHits& hits) {
  if (!(hits.tag == points_tag_)) {
    points_.clear();
    points_tag_ = hits.tag;
  }
  T_zone_base_ = hits.T_zone_base;
  last_hits_ns_ = hits.stamp_ns;
  for (const CellHit& hit : hits.hits) {
    if (hit.z_m < kAboveFloor_m || hit.z_m > kBelowCeiling_m || points_.size() >= kMaxPoints) continue;
    points_.emplace_back(hit.x_m, hit.y_m);
  }
}

void RunRecorder::take_exploration(const ExplorationState& state) {
  // An explorer that was started again counts its sweeps from 0.
  if (state.sweeps_total != record_.exploration.sweeps_total && state.sweeps_total > 0) {
    ++record_.sweeps;
    scan_pending_ = true;
  }
  record_.exploration = state;
  if (state.phase != ExplorationPhase::kStuck) {
    record_.stuck_since_ns = 0;
  } else if (record_.stuck_since_ns == 0) {
    record_.stuck_since_ns = state.stamp_ns;
  }
  keep_scan();
}

void RunRecorder::take_estimate(const RoomEstimate& estimate) {
  estimate_ = estimate;
  keep_scan();
}

void RunRecorder::keep_scan() {
  if (!scan_pending_ || !zone_ || !estimate_ || estimate_->stamp_ns < last_hits_ns_) return;
  scan_pending_ = false;
  const std::uint32_t zone_id = estimate_->tag.zone_id;
  if (zone_->room || zone_->zone_id != zone_id) return;
  record_.scans[zone_id].push_back(
      {.title = "", .estimate = *estimate_, .points = points_, .T_zone_base = T_zone_base_});
}

void RunRecorder::take_ground_truth(const GroundTruth& truth) {
  record_.ground_truth = truth;
  compare_poses();
}

void RunRecorder::take_odometry(const Odometry& odometry) {
  odometry_ = odometry;
  compare_poses();
}

/// Truth and odometry of one moment come in either order.
void RunRecorder::compare_poses() {
  const GroundTruth& truth = record_.ground_truth;
  if (!odometry_ || odometry_->stamp_ns != truth.stamp_ns) return;
  const Pose2 T_world_base = T_world_start_ * T_map_odom_ * to_pose2(odometry_->T_odom_base);
  const double error = (T_world_base.translation() - truth.T_world_base.translation()).norm();
  record_.pose_error_max_m = std::max(record_.pose_error_max_m, error);
}

}  // namespace enfilade::report
