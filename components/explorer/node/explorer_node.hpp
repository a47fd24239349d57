// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "components/explorer/node/explorer_config.hpp"
#include "components/explorer/node/zone_cells.hpp"
#include "interfaces/runtime/node.hpp"
#include "interfaces/runtime/service.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::explorer {

/// Gathers what the others say into an Observation, lets the machine decide every period, and sends what it
/// decided.
class ExplorerNode : public Node {
 public:
  ExplorerNode(const NodeContext& context, const ExplorerConfig& config);

  void initialize() override;
  void compute() override;
  void emergency() override;
  void restore() override {}
  void shutdown() override;

 private:
  template <class T>
  void keep(const Topic<T>& topic, std::optional<T>& newest);
  void take(const GridChange& change);
  void ask_for_cells();
  Observation observe();
  void carry_out(const Decision& decision);
  void stand();
  bool blind() const;
  void publish_state();

  NodeContext context_;
  ExplorerConfig config_;
  ExplorationMachine machine_;
  ZoneCells cells_;

  Publisher<SweepCommand> sweep_command_;
  Publisher<VelocityCommand> cmd_vel_;
  Publisher<ExplorationState> exploration_state_;
  std::unique_ptr<Client<FixRoomRequest, FixRoomReply>> fix_room_;
  std::unique_ptr<Client<EnterZoneRequest, EnterZoneReply>> enter_zone_;
  std::unique_ptr<Client<MarkDoorRequest, MarkDoorReply>> mark_door_;
  std::unique_ptr<Client<GridSnapshotRequest, GridSnapshotReply>> snapshot_;

  std::optional<Odometry> odometry_;
  std::optional<Pose2> T_zone_odom_;  ///< as gridBuilder tells it
  std::optional<MotorState> motor_;
  std::optional<CurrentZone> zone_;
  std::optional<TopologicalMap> map_;
  std::optional<RoomEstimate> estimate_;
  std::optional<PointCloud> points_;
  StampNs points_ns_ = 0, odometry_ns_ = 0;  ///< when they came
  std::optional<FixRoomReply> fixed_;
  std::optional<EnterZoneReply> entered_;
  std::optional<MarkDoorReply> marked_;

  ExplorationState published_;
  StampNs published_ns_ = 0;
  bool was_driving_ = false;
};

}  // namespace enfilade::explorer
