// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/node/explorer_node.hpp"

namespace enfilade::explorer {
namespace {

template <class T>
const T* pointer_to(const std::optional<T>& value) {
  return value ? &*value : nullptr;
}

}  // namespace

ExplorerNode::ExplorerNode(const NodeContext& context, const ExplorerConfig& config)
    : context_(context), config_(config), machine_(config.machine), cells_(config.grid) {}

template <class T>
void ExplorerNode::keep(const Topic<T>& topic, std::optional<T>& newest) {
  context_.bus.subscribe<T>(topic, [&newest](const T& message) { newest = message; });
}

void ExplorerNode::initialize() {
  Bus& bus = context_.bus;
  sweep_command_ = bus.advertise(topics::kSweepCommand);
  cmd_vel_ = bus.advertise(topics::kCmdVel);
  exploration_state_ = bus.advertise(topics::kExplorationState);
  fix_room_ = std::make_unique<Client<FixRoomRequest, FixRoomReply>>(context_, topics::kFixRoom);
  enter_zone_ = std::make_unique<Client<EnterZoneRequest, EnterZoneReply>>(context_, topics::kEnterZone);
  mark_door_ = std::make_unique<Client<MarkDoorRequest, MarkDoorReply>>(context_, topics::kMarkDoor);
  snapshot_ =
      std::make_unique<Client<GridSnapshotRequest, GridSnapshotReply>>(context_, topics::kGridSnapshot);
  keep(topics::kMotorState, motor_);
  keep(topics::kCurrentZone, zone_);
  keep(topics::kTopologicalMap, map_);
  keep(topics::kRoomEstimate, estimate_);
  bus.subscribe<Odometry>(topics::kOdom, [this](const Odometry& o) {
    odometry_ = o;
    odometry_ns_ = context_.clock.now_ns();
  });
  bus.subscribe<TransformList>(topics::kTf, [this](const TransformList& list) {
    if (const auto told = find_zone_odom(list)) T_zone_odom_ = *told;
  });
  bus.subscribe<PointCloud>(topics::kPoints, [this](const PointCloud& p) {
    points_ = p;
    points_ns_ = context_.clock.now_ns();
  });
  bus.subscribe<GridChange>(topics::kGridChange, [this](const GridChange& c) { take(c); });
  ask_for_cells();
}

void ExplorerNode::take(const GridChange& change) {
  if (cells_.take(change) == ZoneCells::Verdict::kNeedsSnapshot) ask_for_cells();
}

void ExplorerNode::ask_for_cells() {
  if (snapshot_->busy()) return;
  snapshot_->call({}, [this](const GridSnapshotReply& reply) {
    if (reply.snapshot.tag.grid_epoch != 0) cells_.take_snapshot(reply.snapshot);
  });
}

void ExplorerNode::compute() {
  const Observation seen = observe();
  const Decision decision = machine_.update(seen);
  fixed_.reset();
  entered_.reset();
  marked_.reset();
  carry_out(decision);
  publish_state();
}

Observation ExplorerNode::observe() {
  Observation seen{.now_ns = context_.clock.now_ns(),
                   .motor = pointer_to(motor_),
                   .zone = pointer_to(zone_),
                   .map = pointer_to(map_),
                   .estimate = pointer_to(estimate_),
                   .grid_tag = cells_.tag(),
                   .grid = &cells_.grid(),
                   .points = pointer_to(points_),
                   .fixed = pointer_to(fixed_),
                   .entered = pointer_to(entered_),
                   .marked = pointer_to(marked_)};
  if (odometry_ && T_zone_odom_) {
    seen.T_zone_base = *T_zone_odom_ * to_pose2(odometry_->T_odom_base);
    seen.pose_stamp_ns = odometry_->stamp_ns;
    seen.speed = {odometry_->linear_m_s, odometry_->angular_rad_s};
  }
  return seen;
}

void ExplorerNode::carry_out(const Decision& decision) {
  for (const std::string& text : decision.events) context_.log.info(text);
  for (const std::string& text : decision.warnings) context_.log.warn(text);
  if (decision.sweep) sweep_command_.publish(*decision.sweep);
  if (decision.fix_room) fix_room_->call(*decision.fix_room, [this](const FixRoomReply& r) { fixed_ = r; });
  if (decision.enter_zone)
    enter_zone_->call(*decision.enter_zone, [this](const EnterZoneReply& r) { entered_ = r; });
  if (decision.mark_door)
    mark_door_->call(*decision.mark_door, [this](const MarkDoorReply& r) { marked_ = r; });
  if (decision.drives && !blind()) {
    cmd_vel_.publish(decision.velocity);
  } else if (was_driving_ || decision.drives) {
    stand();
  }
  was_driving_ = decision.drives;
}

/// Without odometry or returns of the sensor it does not drive.
bool ExplorerNode::blind() const {
  const StampNs now_ns = context_.clock.now_ns();
  return seconds(now_ns - odometry_ns_) > config_.odometry_stale_s || !points_ ||
         seconds(now_ns - points_ns_) > config_.points_stale_s;
}

void ExplorerNode::stand() { cmd_vel_.publish({}); }

void ExplorerNode::emergency() {
  stand();
  context_.lifecycle.go_to_restore();
}

void ExplorerNode::shutdown() { stand(); }

void ExplorerNode::publish_state() {
  ExplorationState state = machine_.state();
  if (const auto tag = cells_.tag()) state.tag = *tag;
  state.stamp_ns = published_.stamp_ns;
  const StampNs now_ns = context_.clock.now_ns();
  if (state == published_ && seconds(now_ns - published_ns_) < config_.state_period_s) return;
  state.stamp_ns = now_ns;
  published_ = state;
  published_ns_ = now_ns;
  exploration_state_.publish(state);
}

}  // namespace enfilade::explorer
