// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/node/laser_3d_node.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "components/laser3D/node/frames.hpp"
#include "components/laser3D/node/simulator_scan_driver.hpp"
#include "interfaces/model/counted.hpp"

namespace enfilade::laser_3d {

Laser3DNode::Laser3DNode(const NodeContext& context, const Laser3DConfig& config)
    : context_(context),
      config_(config),
      roll_(config.roll),
      queue_(config.queue),
      projector_(config.projector) {
  switch (config.driver) {
    case DriverKind::kSimulator:
      driver_ = std::make_unique<SimulatorScanDriver>(context.bus);
      break;
    case DriverKind::kReplay:
      replay_ = std::make_unique<CloudReplay>(context, config.replay);
      break;
  }
}

void Laser3DNode::initialize() {
  points_ = context_.bus.advertise(topics::kPoints);
  tf_static_ = context_.bus.advertise(topics::kTfStatic);
  points_free_ = context_.bus.advertise(topics::kPointsFree);
  if (replay_) {
    replay_->start(points_, points_free_, tf_static_);
  } else {
    start_scanning();
  }
}

void Laser3DNode::start_scanning() {
  scan_ = context_.bus.advertise(topics::kScan);
  tf_ = context_.bus.advertise(topics::kTf);
  const ScanProjectorConfig& mount = config_.projector;
  tf_static_.publish(
      mount_transform(context_.clock.now_ns(), mount.mount_x_m, mount.mount_y_m, mount.mount_z_m));
  context_.bus.subscribe<JointStates>(topics::kJointStates,
                                      [this](const JointStates& joints) { take(joints); });
  driver_->start([this](const LaserScan& line) { take(line); });
}

void Laser3DNode::compute() {
  if (!driver_) return;
  warn_of_dropped_lines();
  if (scans_silent())
    context_.lifecycle.go_to_emergency("no scan line for " + std::to_string(config_.scan_silence_s) + " s");
}

void Laser3DNode::emergency() {
  if (!scans_silent()) context_.lifecycle.go_to_restore();
}

bool Laser3DNode::scans_silent() {
  const StampNs now_ns = context_.clock.now_ns();
  if (!heard_ns_) heard_ns_ = now_ns;
  return seconds(now_ns - *heard_ns_) > config_.scan_silence_s;
}

void Laser3DNode::take(const LaserScan& line) {
  heard_ns_ = context_.clock.now_ns();
  LaserScan scan = line;
  scan.frame_id = kLaserScanFrame;
  queue_.push(scan);
  scan_.publish(std::move(scan));
  publish_ready_lines();
}

void Laser3DNode::take(const JointStates& joints) {
  const auto name = std::find(joints.names.begin(), joints.names.end(), kRollJoint);
  const auto index = static_cast<std::size_t>(name - joints.names.begin());
  if (index >= joints.positions_rad.size()) return;
  roll_.add(joints.stamp_ns, joints.positions_rad[index]);
  publish_ready_lines();
}

void Laser3DNode::publish_ready_lines() {
  while (const auto line = queue_.pop(roll_)) publish(*line);
}

void Laser3DNode::publish(const RolledLine& line) {
  const StampNs stamp_ns = line.scan.stamp_ns;
  if (!line.roll_rad.empty()) tf_.publish(roll_transform(stamp_ns, line.roll_rad.front()));
  ProjectedLine projected = projector_.project(line);
  points_.publish({.stamp_ns = stamp_ns, .frame_id = kBaseFrame, .points = std::move(projected.points)});
  if (!projected.free_ends.empty())
    points_free_.publish(
        {.stamp_ns = stamp_ns, .frame_id = kBaseFrame, .points = std::move(projected.free_ends)});
}

void Laser3DNode::warn_of_dropped_lines() {
  if (queue_.dropped() == dropped_told_) return;
  context_.log.warn(counted(queue_.dropped() - dropped_told_, "scan line") +
                    " dropped: the roll angle was not known for them");
  dropped_told_ = queue_.dropped();
}

}  // namespace enfilade::laser_3d
