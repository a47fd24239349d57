// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/node/cloud_replay.hpp"

#include <stdexcept>
#include <string>

#include "components/laser3D/node/frames.hpp"
#include "interfaces/geometry/angles.hpp"
#include "interfaces/model/counted.hpp"
#include "interfaces/runtime/read_file.hpp"

namespace enfilade::laser_3d {
namespace {

FileBytes bytes_of(const std::string& name) {
  if (name.empty())
    throw std::runtime_error("driver is 'replay' but replay.file is empty: name a .pcd or .3d file");
  return {name, read_file(name)};
}

std::string two_decimals(double value) {
  std::string text = std::to_string(value);
  text.resize(text.find('.') + 3);
  return text;
}

}  // namespace

CloudReplay::CloudReplay(const NodeContext& context, const ReplayConfig& config)
    : context_(context), config_(config) {}

void CloudReplay::start(const Publisher<PointCloud>& points, const Publisher<PointCloud>& points_free,
                        const Publisher<TransformList>& tf_static) {
  const FileBytes file = bytes_of(config_.file);
  auto cloud = make_replay_cloud(config_.cloud, read_points(file));
  if (!cloud)
    throw std::runtime_error(file.name +
                             ": no floor is to be found below the scanner, so its height is unknown");
  cloud_ = std::move(*cloud);
  points_ = &points;
  points_free_ = &points_free;
  opened_ns_ = context_.clock.now_ns();
  context_.log.info("replay of " + file.name + ": floor " + two_decimals(cloud_.scanner_height_m) +
                    " m below the scanner, which leaned by " + two_decimals(degrees(cloud_.tilt_rad)) +
                    " degrees; " + counted(cloud_.points, "point") + " to play, " +
                    std::to_string(cloud_.near_floor) + " near the floor as free space");
  tf_static.publish(mount_transform(opened_ns_, 0.0, 0.0, cloud_.scanner_height_m));
  context_.executor.every(from_seconds(config_.line_period_s / config_.rate), [this] { step(); });
}

bool CloudReplay::may_begin() {
  begun_ = begun_ || points_->matched_readers() >= 1 ||
           seconds(context_.clock.now_ns() - opened_ns_) >= config_.wait_s;
  return begun_;
}

void CloudReplay::step() {
  if (finished_ || !may_begin()) return;
  if (next_line_ == cloud_.lines.size()) return finish();
  const StampNs stamp_ns = static_cast<StampNs>(next_line_ + 1) * from_seconds(config_.line_period_s);
  points_->publish(
      {.stamp_ns = stamp_ns, .frame_id = kBaseFrame, .points = std::move(cloud_.lines[next_line_])});
  points_free_->publish(
      {.stamp_ns = stamp_ns, .frame_id = kBaseFrame, .points = std::move(cloud_.free_ends[next_line_])});
  ++next_line_;
}

void CloudReplay::finish() {
  finished_ = true;
  context_.log.info("replay finished: " + counted(cloud_.points, "point") + " in " +
                    counted(cloud_.lines.size(), "line"));
}

}  // namespace enfilade::laser_3d
