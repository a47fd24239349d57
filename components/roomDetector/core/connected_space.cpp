// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/connected_space.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::room_detector {
namespace {

constexpr int kStartBlocks = 5;  // the robot's own place may not have been seen at these heights

}  // namespace

ConnectedSpace::ConnectedSpace(double cell_m, const Point2& origin, double reach_m) : cell_m_(cell_m) {
  const int reach = static_cast<int>(std::ceil(reach_m / cell_m)) + 2;
  first_x_ = static_cast<int>(std::floor(origin.x() / cell_m)) - reach;
  first_y_ = static_cast<int>(std::floor(origin.y() / cell_m)) - reach;
  side_ = reach + 1;
  blocks_.resize(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_));
  reached_.resize(blocks_.size());
}

void ConnectedSpace::change(int x, int y, Kind from, Kind to) {
  const int i = index_of(x, y);
  if (i < 0 || from == to) return;
  Block& block = blocks_[static_cast<std::size_t>(i)];
  const bool was_open = block.is_open();
  block.open = static_cast<std::uint8_t>(block.open + (to == Kind::kOpen) - (from == Kind::kOpen));
  block.walls = static_cast<std::uint8_t>(block.walls + (to == Kind::kWall) - (from == Kind::kWall));
  is_stale_ |= block.is_open() != was_open;
}

/// The open block nearest to a block, by rings about it; -1 where there is none.
int ConnectedSpace::start_near(int index) const {
  for (int ring = 0; ring <= kStartBlocks; ++ring) {
    for (int dx = -ring; dx <= ring; ++dx) {
      for (int dy = -ring; dy <= ring; ++dy) {
        if (std::max(std::abs(dx), std::abs(dy)) != ring) continue;
        const int i = index + dx * side_ + dy;
        if (i >= 0 && i < static_cast<int>(blocks_.size()) && blocks_[static_cast<std::size_t>(i)].is_open())
          return i;
      }
    }
  }
  return -1;
}

void ConnectedSpace::flood(const Point2& robot) {
  const int at = index_of(static_cast<int>(std::floor(robot.x() / cell_m_)),
                          static_cast<int>(std::floor(robot.y() / cell_m_)));
  const int start = at < 0 ? -1 : start_near(at);
  const bool is_known = knows_robot_ && start >= 0 && reached_[static_cast<std::size_t>(start)] != 0;
  if (is_known && !is_stale_) return;
  is_stale_ = false;
  for (const int i : front_) reached_[static_cast<std::size_t>(i)] = 0;
  front_.clear();
  knows_robot_ = start >= 0;
  if (!knows_robot_) return;
  front_.assign(1, start);
  reached_[static_cast<std::size_t>(start)] = 1;
  const auto is_wall = [&](int block) { return blocks_[static_cast<std::size_t>(block)].walls > 0; };
  for (std::size_t k = 0; k < front_.size(); ++k) {
    for (const int dx : {-side_, 0, side_}) {
      for (const int dy : {-1, 0, 1}) {
        const int next = front_[k] + dx + dy;
        if (reached_[static_cast<std::size_t>(next)] != 0 ||
            !blocks_[static_cast<std::size_t>(next)].is_open())
          continue;
        if (is_wall(front_[k] + dx) && is_wall(front_[k] + dy)) continue;  // they meet at this corner
        reached_[static_cast<std::size_t>(next)] = 1;
        front_.push_back(next);
      }
    }
  }
}

}  // namespace enfilade::room_detector
