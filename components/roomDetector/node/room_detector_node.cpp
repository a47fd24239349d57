// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/node/room_detector_node.hpp"

#include <algorithm>
#include <utility>

namespace enfilade::room_detector {

RoomDetectorNode::RoomDetectorNode(const NodeContext& context, const RoomDetectorNodeConfig& config)
    : context_(context),
      crew_(config.search_threads),
      detector_(config.detector,
                {.workers = crew_.size(),
                 .run = [this](int tasks, const TaskRunner::Work& work) { crew_.run(tasks, work); }}),
      grid_({.start = [this](const GridChange& change) { start_grid(change); },
             .apply =
                 [this](const GridChange& change) {
                   detector_.update(change);
                   grid_changed(change);
                 },
             .adopt =
                 [this](const GridChange& snapshot) {
                   detector_.adopt(snapshot);
                   grid_changed(snapshot);
                 },
             .ask_for_snapshot = [this] { ask_for_snapshot(); }}),
      diagnostics_period_s_(config.diagnostics_period_s),
      every_line_(config.every_line) {}

void RoomDetectorNode::initialize() {
  estimate_ = context_.bus.advertise(topics::kRoomEstimate);
  diagnostics_ = context_.bus.advertise(topics::kRoomDiagnostics);
  snapshot_.emplace(context_, topics::kGridSnapshot);
  context_.bus.subscribe<GridChange>(topics::kGridChange,
                                     [this](const GridChange& change) { grid_.take_change(change); });
  context_.bus.subscribe<ScanHits>(topics::kScanHits, [this](const ScanHits& hits) { take_hits(hits); });
  ask_for_snapshot();  // a grid may have been growing before this process began
}

void RoomDetectorNode::compute() { estimate(); }

/// The estimate waits behind what is queued already, so that a detector that lags behind takes several lines
/// at once.
void RoomDetectorNode::line_came() {
  const bool is_complete = grid_stamp_ns_ >= hits_stamp_ns_ && hits_stamp_ns_ != 0;
  if (!every_line_ || !is_complete || estimated_line_ns_ == hits_stamp_ns_) return;
  estimated_line_ns_ = hits_stamp_ns_;
  if (std::exchange(is_due_, true)) return;
  context_.executor.post([this] {
    is_due_ = false;
    estimate();
  });
}

void RoomDetectorNode::estimate() {
  if (!has_news_ || grid_.is_waiting() || !grid_.tag()) return;
  has_news_ = false;
  Detection detection = detector_.estimate(T_zone_base_);
  if (detection.diagnostics.search.gap > 0)
    context_.log.debug("the best rectangle is not proven: max_expansions reached");
  RoomEstimate& estimate = detection.estimate;
  estimate.tag = *grid_.tag();
  estimate.grid_sequence = grid_.sequence();
  estimate.stamp_ns = std::max(grid_stamp_ns_, hits_stamp_ns_);
  if (estimate.recent) estimate.recent_stamp_ns = hits_stamp_ns_;
  estimate_.publish(estimate);  // first: somebody waits for it
  publish_diagnostics(detection, estimate);
}

void RoomDetectorNode::publish_diagnostics(const Detection& detection, const RoomEstimate& estimate) {
  const StampNs now_ns = context_.clock.now_ns();
  if (explained_ns_ && seconds(now_ns - *explained_ns_) < diagnostics_period_s_) return;
  explained_ns_ = now_ns;
  RoomDiagnostics why = detector_.explain(detection);
  why.tag = estimate.tag;
  why.grid_sequence = estimate.grid_sequence;
  why.stamp_ns = estimate.stamp_ns;
  diagnostics_.publish(std::move(why));
}

void RoomDetectorNode::start_grid(const GridChange& change) {
  detector_.clear(change.resolution_m);
  T_zone_base_.reset();
  grid_stamp_ns_ = hits_stamp_ns_ = 0;
  estimated_line_ns_.reset();
}

void RoomDetectorNode::grid_changed(const GridChange& change) {
  grid_stamp_ns_ = change.stamp_ns;
  has_news_ = true;
  line_came();
}

void RoomDetectorNode::take_hits(const ScanHits& hits) {
  if (!grid_.tag() || !(*grid_.tag() == hits.tag)) return;
  detector_.add_hits(hits);
  T_zone_base_ = hits.T_zone_base;
  hits_stamp_ns_ = hits.stamp_ns;
  has_news_ = true;
  line_came();
}

void RoomDetectorNode::ask_for_snapshot() {
  snapshot_->call({}, [this](const GridSnapshotReply& reply) { grid_.take_snapshot(reply.snapshot); });
}

}  // namespace enfilade::room_detector
