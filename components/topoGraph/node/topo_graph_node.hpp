// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "components/topoGraph/core/topo_graph.hpp"
#include "components/topoGraph/node/metric_map_publisher.hpp"
#include "components/topoGraph/node/topo_graph_config.hpp"
#include "components/topoGraph/storage/map_store.hpp"
#include "interfaces/runtime/service.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::topo_graph {

/// Serves the requests of the room-change protocol and publishes map, current zone and map → odom. What is
/// announced has been written before; a change that cannot be written is taken back and refused.
class TopoGraphNode final : public Node {
 public:
  TopoGraphNode(const NodeContext& context, const TopoGraphConfig& config);

  void initialize() override;
  void compute() override;
  void shutdown() override;

 private:
  KeptState start_state();
  KeptState resumed_state();
  void open_topics();
  FixRoomReply on_fix_room(const FixRoomRequest& request);
  EnterZoneReply on_enter_zone(const EnterZoneRequest& request);
  MarkDoorReply on_mark_door(const MarkDoorRequest& request);
  void look_at_estimate();
  void warn_of_lost_zone(const RoomEstimate& estimate);
  std::optional<std::string> commit(const TopoState& before);
  void announce(const TopoState& before);
  void publish_transform();

  NodeContext context_;
  TopoGraphConfig config_;
  TopoGraph graph_;
  std::optional<MapStore> store_;         ///< where there is a map_file
  std::optional<RoomEstimate> estimate_;  ///< the newest that was not looked at yet
  std::optional<StampNs> looked_ns_;
  std::optional<std::uint32_t> lost_in_boot_;
  bool write_failed_ = false;
  Pose2 T_zone_odom_;  ///< as gridBuilder tells it
  Publisher<TopologicalMap> map_;
  Publisher<CurrentZone> zone_;
  Publisher<PoseCorrection> correction_;
  Publisher<TransformList> tf_;
  MetricMapPublisher metric_map_;
};

}  // namespace enfilade::topo_graph
