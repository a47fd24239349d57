// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/floor_map.hpp"

#include <cmath>

#include "components/explorer/core/distance_field.hpp"

namespace enfilade::explorer {
namespace {

constexpr int kParts = 3;  // an odd number: one part has the centre of the whole cell

}  // namespace

FloorMap::FloorMap(const ProjectedGrid& grid, const FloorHints& hints, const FloorMapConfig& config)
    : origin_(grid.origin()),
      width_(grid.width()),
      height_(grid.height()),
      resolution_m_(grid.resolution_m()) {
  cells_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (std::size_t i = 0; i < cells_.size(); ++i) cells_[i] = grid.floor(cell(i));
  fill_holes();
  for (const Point2& p : hints.trodden) tread(p, config);
  for (const Point2& p : hints.passing) {
    if (contains(cell_at(p))) cells_[index(cell_at(p))] = Floor::kFree;
  }
  for (const Point2& p : hints.obstacles) {
    if (contains(cell_at(p))) cells_[index(cell_at(p))] = Floor::kObstacle;
  }
  to_obstacle_m_ = distance_to(Floor::kObstacle);
  to_unexplored_m_ = distance_to(Floor::kUnexplored);
}

FloorMap FloorMap::refined() const {
  FloorMap fine = *this;
  fine.origin_ = {kParts * origin_.x, kParts * origin_.y};
  fine.width_ = kParts * width_;
  fine.height_ = kParts * height_;
  fine.resolution_m_ = resolution_m_ / kParts;
  fine.cells_.resize(cells_.size() * kParts * kParts);
  for (std::size_t i = 0; i < fine.cells_.size(); ++i) {
    const int x = static_cast<int>(i) % fine.width_ / kParts, y = static_cast<int>(i) / fine.width_ / kParts;
    fine.cells_[i] = cells_[index({origin_.x + x, origin_.y + y})];
  }
  fine.to_obstacle_m_ = fine.distance_to_uncut(Floor::kObstacle);
  fine.to_unexplored_m_ = fine.distance_to_uncut(Floor::kUnexplored);
  return fine;
}

CellXY FloorMap::cell_at(const Point2& p) const {
  return {static_cast<int>(std::floor(p.x() / resolution_m_)),
          static_cast<int>(std::floor(p.y() / resolution_m_))};
}

void FloorMap::tread(const Point2& p, const FloorMapConfig& config) {
  const CellXY middle = cell_at(p);
  const int reach = static_cast<int>(std::ceil(config.trodden_radius_m / resolution_m_));
  for (int y = middle.y - reach; y <= middle.y + reach; ++y) {
    for (int x = middle.x - reach; x <= middle.x + reach; ++x) {
      const CellXY c{x, y};
      const double distance_m = (centre(c) - p).norm();
      if (!contains(c) || distance_m > config.trodden_radius_m) continue;
      const bool covered = distance_m <= config.body_radius_m;
      if (covered || cells_[index(c)] == Floor::kUnexplored) cells_[index(c)] = Floor::kFree;
    }
  }
}

void FloorMap::fill_holes() {
  const std::vector<Floor> before = cells_;
  const auto n = static_cast<std::ptrdiff_t>(width_);
  for (int y = 1; y + 1 < height_; ++y) {
    for (int x = 1; x + 1 < width_; ++x) {
      const std::ptrdiff_t i = y * n + x;
      if (before[static_cast<std::size_t>(i)] != Floor::kUnexplored) continue;
      int free = 0, obstacles = 0;
      for (const std::ptrdiff_t j :
           {i - n - 1, i - n, i - n + 1, i - 1, i + 1, i + n - 1, i + n, i + n + 1}) {
        free += before[static_cast<std::size_t>(j)] == Floor::kFree;
        obstacles += before[static_cast<std::size_t>(j)] == Floor::kObstacle;
      }
      if (free >= 5 && obstacles == 0) cells_[static_cast<std::size_t>(i)] = Floor::kFree;
    }
  }
}

std::vector<float> FloorMap::distance_to(Floor what) const {
  std::vector<std::uint8_t> set(cells_.size());
  for (std::size_t i = 0; i < set.size(); ++i) set[i] = cells_[i] == what;
  return distance_to(set);
}

/// Of refined cells only those count that have the centre of an uncut one.
std::vector<float> FloorMap::distance_to_uncut(Floor what) const {
  std::vector<std::uint8_t> set(cells_.size());
  for (int y = kParts / 2; y < height_; y += kParts)
    for (int x = kParts / 2; x < width_; x += kParts) {
      const std::size_t i = index({origin_.x + x, origin_.y + y});
      set[i] = cells_[i] == what;
    }
  return distance_to(set);
}

std::vector<float> FloorMap::distance_to(const std::vector<std::uint8_t>& set) const {
  std::vector<float> distance = distance_field(set, width_, height_);
  for (float& d : distance) d *= static_cast<float>(resolution_m_);
  return distance;
}

}  // namespace enfilade::explorer
