// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/roomDetector/node/grid_follower.hpp"
#include "components/roomDetector/node/room_detector_config.hpp"
#include "interfaces/runtime/crew.hpp"
#include "interfaces/runtime/node.hpp"
#include "interfaces/runtime/service.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::room_detector {

/// Follows the grid of the current zone and publishes the room model once for each scan line, as soon as its
/// cells and its returns are there; what else has changed comes with the next line, or at the next period.
class RoomDetectorNode : public Node {
 public:
  RoomDetectorNode(const NodeContext& context, const RoomDetectorNodeConfig& config);

  void initialize() override;
  void compute() override;

 private:
  void line_came();
  void estimate();
  void start_grid(const GridChange& change);
  void grid_changed(const GridChange& change);
  void take_hits(const ScanHits& hits);
  void ask_for_snapshot();

  NodeContext context_;
  Crew crew_;
  RoomDetector detector_;
  GridFollower grid_;
  void publish_diagnostics(const Detection& detection, const RoomEstimate& estimate);

  Publisher<RoomEstimate> estimate_;
  Publisher<RoomDiagnostics> diagnostics_;
  double diagnostics_period_s_;
  std::optional<StampNs> explained_ns_;
  std::optional<Client<GridSnapshotRequest, GridSnapshotReply>> snapshot_;
  std::optional<Pose2> T_zone_base_;
  StampNs grid_stamp_ns_ = 0, hits_stamp_ns_ = 0;
  std::optional<StampNs> estimated_line_ns_;  ///< the last one that an estimate was asked for
  bool every_line_;
  bool has_news_ = false, is_due_ = false;
};

}  // namespace enfilade::room_detector
