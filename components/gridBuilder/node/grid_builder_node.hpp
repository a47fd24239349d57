// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>

#include "components/gridBuilder/core/line_placement.hpp"
#include "components/gridBuilder/core/scan_registrar.hpp"
#include "components/gridBuilder/node/grid_builder_config.hpp"
#include "components/gridBuilder/node/picture_publisher.hpp"
#include "interfaces/runtime/node.hpp"
#include "interfaces/runtime/service.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::grid_builder {

/// Brings scan lines, odometry, motor states and the current zone together and publishes what they change in
/// the grid. A line is worked off in the very callback that completes it, never by a timer.
class GridBuilderNode : public Node {
 public:
  GridBuilderNode(const NodeContext& context, const GridBuilderConfig& config);

  void initialize() override;
  void compute() override;

 private:
  struct SettledLine {
    BaseLine line;
    Pose2 T_zone_base;
  };

  void take_tf(const TransformList& transforms);
  void take_tf_static(const TransformList& transforms);
  void take_odometry(const Odometry& odometry);
  void start_from(const Pose2& T_zone_odom);
  void take_zone(const CurrentZone& zone);
  void take_motor_state(const MotorState& state);
  void start_grid();
  void work_off_lines();
  std::optional<BaseMoment> find_moment(StampNs stamp_ns) const;
  std::optional<KnownWalls> walls() const;
  void queue(const std::vector<PlacedLine>& lines);
  void fuse(int most);
  void insert(const BaseLine& line, const Pose2& T_zone_base);
  void publish_zone_frame();
  GridChange change(StampNs stamp_ns, std::vector<GridCell> cells) const;
  GridSnapshotReply snapshot() const;

  NodeContext context_;
  GridBuilderConfig config_;
  ZoneGate gate_;
  ZoneGrid grid_;
  OdometryBuffer odometry_;
  WaitingLines lines_;
  ScanRegistrar registrar_;
  std::deque<SettledLine> settled_;     ///< waiting to be fused; at most registration.max_held_lines and one
  RoomEstimate room_;                   ///< as last told
  std::optional<Point3f> origin_base_;  ///< of the beams, once rt/tf_static has told it
  std::optional<Pose2> T_map_zone_;
  int waited_for_drift_ = 0;  ///< periods in which the zone was known and the drift of odometry was not
  bool drift_known_ = false;  ///< else lines wait
  std::optional<std::uint32_t> odom_boot_;  ///< as last told by the motors
  std::optional<StampNs> unsure_since_ns_;  ///< odometry from here on may be of the next boot
  StampNs newest_line_ns_ = 0;
  bool line_came_ = false;  ///< since the last compute()
  std::size_t overflow_told_ = 0;
  bool memory_told_ = false;
  Publisher<GridChange> changes_;
  Publisher<ScanHits> hits_;
  Publisher<TransformList> tf_;
  PicturePublisher pictures_;
};

}  // namespace enfilade::grid_builder
