// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/node/topo_graph_node.hpp"

#include <exception>
#include <filesystem>
#include <utility>

#include "components/topoGraph/node/story.hpp"
#include "components/topoGraph/routes/route_answer.hpp"
#include "components/topoGraph/storage/map_file.hpp"
#include "components/topoGraph/storage/map_folder.hpp"

namespace enfilade::topo_graph {

TopoGraphNode::TopoGraphNode(const NodeContext& context, const TopoGraphConfig& config)
    : context_(context),
      config_(config),
      graph_(config.graph, first_state(context.clock.now_ns())),
      metric_map_(context, config.metric_map) {}

void TopoGraphNode::initialize() {
  const KeptState start = start_state();
  graph_.reset_to(start.state);
  if (!config_.map_file.empty()) {
    store_.emplace(MapStoreConfig{config_.map_file, 1024 * static_cast<std::size_t>(config_.journal_kib)},
                   start.records);
    store_->begin(graph_.state());
  }
  open_topics();
  map_.publish(graph_.state().map);
  zone_.publish(graph_.state().session.zone);
  publish_transform();
}

void TopoGraphNode::shutdown() {
  if (store_) store_->end(graph_.state());
}

/// The metric map comes after the answers to what has changed the graph: nobody waits for its drawing.
void TopoGraphNode::compute() {
  look_at_estimate();
  publish_transform();
  metric_map_.update(graph_.state().map);
}

KeptState TopoGraphNode::start_state() {
  const std::filesystem::path file = config_.map_file;
  if (std::filesystem::is_directory(file))
    throw MapFileError("map_file: " + file.string() + " is a folder; name a file in it");
  if (!file.empty() && std::filesystem::exists(file)) {
    if (config_.resume) return resumed_state();
    const std::filesystem::path kept = file.string() + ".previous";
    move_map(file, kept);
    context_.log.info("a new map is started; the one before is kept in " + kept.string());
  }
  return {.state = first_state(context_.clock.now_ns())};
}

KeptState TopoGraphNode::resumed_state() {
  KeptState kept = config_.locate ? load_to_locate(config_.map_file) : load_kept(config_.map_file);
  context_.log.info(tell_resumed(kept.state));
  if (kept.torn) context_.log.warn(*kept.torn);
  if (config_.locate) kept.state = lost_state(kept.state.map, kept.state.session, context_.clock.now_ns());
  return kept;
}

void TopoGraphNode::open_topics() {
  map_ = context_.bus.advertise(topics::kTopologicalMap);
  zone_ = context_.bus.advertise(topics::kCurrentZone);
  correction_ = context_.bus.advertise(topics::kPoseCorrection);
  tf_ = context_.bus.advertise(topics::kTf);
  metric_map_.open();
  serve<FixRoomRequest, FixRoomReply>(context_.bus, topics::kFixRoom,
                                      [this](const auto& q) { return on_fix_room(q); });
  serve<EnterZoneRequest, EnterZoneReply>(context_.bus, topics::kEnterZone,
                                          [this](const auto& q) { return on_enter_zone(q); });
  serve<MarkDoorRequest, MarkDoorReply>(context_.bus, topics::kMarkDoor,
                                        [this](const auto& q) { return on_mark_door(q); });
  // A repeated request gets what is true now.
  serve<RouteRequest, RouteReply>(context_.bus, topics::kRoute,
                                  [this](const auto& q) { return answer_route(graph_.state().map, q); });
  context_.bus.subscribe<RoomEstimate>(topics::kRoomEstimate, [this](const RoomEstimate& e) {
    estimate_ = e;
    look_at_estimate();
  });
  context_.bus.subscribe<TransformList>(topics::kTf, [this](const TransformList& list) {
    const auto told = find_zone_odom(list);
    if (!told || *told == T_zone_odom_) return;
    T_zone_odom_ = *told;
    publish_transform();
  });
}

FixRoomReply TopoGraphNode::on_fix_room(const FixRoomRequest& request) {
  const TopoState before = graph_.state();
  const FixRoomOutcome outcome = graph_.fix_room(request, context_.clock.now_ns());
  if (const auto problem = commit(before)) return {.message = *problem};
  if (outcome.fixed) context_.log.info(tell(outcome, graph_.state().map));
  if (!outcome.reply.accepted) context_.log.warn("room not fixed: " + outcome.reply.message);
  if (outcome.correction) correction_.publish(*outcome.correction);
  announce(before);
  return outcome.reply;
}

EnterZoneReply TopoGraphNode::on_enter_zone(const EnterZoneRequest& request) {
  const TopoState before = graph_.state();
  const EnterZoneOutcome outcome = graph_.enter_zone(request, context_.clock.now_ns());
  if (const auto problem = commit(before)) return {.message = *problem};
  if (outcome.entered) context_.log.info(tell(outcome, graph_.state().session.zone));
  if (!outcome.reply.accepted) context_.log.warn("zone not changed: " + outcome.reply.message);
  announce(before);
  return outcome.reply;
}

MarkDoorReply TopoGraphNode::on_mark_door(const MarkDoorRequest& request) {
  const TopoState before = graph_.state();
  const MarkDoorOutcome outcome = graph_.mark_door(request, context_.clock.now_ns());
  if (const auto problem = commit(before)) return {.message = *problem};
  if (outcome.marked) context_.log.info(tell(request));
  if (!outcome.reply.accepted) context_.log.warn("door not marked: " + outcome.reply.message);
  announce(before);
  return outcome.reply;
}

/// There is one for each scan line. Those of one sweep are no independent witnesses, and every correction is
/// a change to be kept.
void TopoGraphNode::look_at_estimate() {
  const StampNs now_ns = context_.clock.now_ns();
  if (!estimate_ || (looked_ns_ && seconds(now_ns - *looked_ns_) < config_.estimate_period_s)) return;
  looked_ns_ = now_ns;
  const RoomEstimate estimate = *std::exchange(estimate_, std::nullopt);
  const TopoState before = graph_.state();
  const ObserveOutcome outcome = graph_.observe(estimate);
  if (outcome.odometry_restarted && !outcome.room_found_again) warn_of_lost_zone(estimate);
  if (!outcome.correction || commit(before)) return;
  context_.log.info(tell(outcome, graph_.state().map));
  correction_.publish(*outcome.correction);
  announce(before);
}

void TopoGraphNode::warn_of_lost_zone(const RoomEstimate& estimate) {
  if (lost_in_boot_ == estimate.tag.odom_boot) return;
  lost_in_boot_ = estimate.tag.odom_boot;
  context_.log.warn(graph_.state().session.zone.room
                        ? "odometry started anew; the room has not been found in it yet"
                        : "odometry started anew; the room is modelled on from where the robot stood");
}

/// Writes what has changed since `before`. Where that fails the change is undone, and the reason returned.
std::optional<std::string> TopoGraphNode::commit(const TopoState& before) {
  if (!store_ || graph_.state() == before) return std::nullopt;
  try {
    store_->keep(before, graph_.state());
    write_failed_ = false;
    return std::nullopt;
  } catch (const std::exception& error) {
    graph_.reset_to(before);
    const std::string problem = std::string("the map cannot be kept: ") + error.what();
    if (!std::exchange(write_failed_, true)) context_.log.error(problem);
    return problem;
  }
}

void TopoGraphNode::announce(const TopoState& before) {
  const TopoState& now = graph_.state();
  if (now.map.version != before.map.version) map_.publish(now.map);
  if (now.session.zone == before.session.zone) return;
  publish_transform();
  zone_.publish(now.session.zone);
}

void TopoGraphNode::publish_transform() {
  const Pose2 T_map_odom = graph_.state().session.zone.T_map_zone * T_zone_odom_;
  tf_.publish({{{context_.clock.now_ns(), "map", "odom", to_transform3(T_map_odom)}}});
}

}  // namespace enfilade::topo_graph
