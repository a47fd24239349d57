// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/node/picture_publisher.hpp"

#include <algorithm>
#include <utility>

namespace enfilade::grid_builder {
namespace {

constexpr std::size_t kTilesPerSlice = 128;  // a millisecond or two

}  // namespace

PicturePublisher::PicturePublisher(const NodeContext& context, const PicturePublisherConfig& config,
                                   const ZoneGrid& grid, std::string frame)
    : context_(context), config_(config), grid_(grid), frame_(std::move(frame)), pictures_(config.pictures) {}

void PicturePublisher::open() {
  if (config_.period_s <= 0.0) return;
  octomap_ = context_.bus.advertise(topics::kOctomap);
  local_map_ = context_.bus.advertise(topics::kLocalMap);
  context_.executor.every(from_seconds(config_.period_s), [this] { tick(); });
}

void PicturePublisher::grid_cleared() {
  pictures_.clear();
  has_news_ = false;
  newest_line_ns_ = 0;
}

void PicturePublisher::line_fused(const LineUpdate& update, StampNs stamp_ns, const Pose2& T_zone_base) {
  newest_line_ns_ = std::max(newest_line_ns_, stamp_ns);
  robot_ = T_zone_base.translation();
  if (update.changes.empty()) return;
  has_news_ = true;
  pictures_.note(update.changes);
}

void PicturePublisher::tick() {
  if (octomap_.matched_readers() == 0 && local_map_.matched_readers() == 0) {
    if (pictures_.is_following()) pictures_.stop_following();
    return;
  }
  if (!pictures_.is_following()) {
    pictures_.follow(grid_);
    has_news_ = true;
  }
  if (has_news_ && !std::exchange(works_, true)) work();
}

void PicturePublisher::work() {
  const auto go_on = [this](void (PicturePublisher::*step)()) {
    context_.executor.post([this, step] { (this->*step)(); });
  };
  if (pictures_.draw(grid_, kTilesPerSlice)) return go_on(&PicturePublisher::work);
  has_news_ = works_ = false;
  go_on(&PicturePublisher::publish_octree);
  go_on(&PicturePublisher::publish_floor);
}

void PicturePublisher::publish_octree() {
  OctreeMap map{newest_line_ns_, frame_, grid_.config().resolution_m, pictures_.octree()};
  if (!map.data.empty() && octomap_.matched_readers() > 0) octomap_.publish(std::move(map));
}

void PicturePublisher::publish_floor() {
  OccupancyMap map = pictures_.floor(grid_.config().resolution_m, robot_);
  if (map.cells.empty() || local_map_.matched_readers() == 0) return;
  map.stamp_ns = newest_line_ns_;
  map.frame_id = frame_;
  local_map_.publish(std::move(map));
}

}  // namespace enfilade::grid_builder
