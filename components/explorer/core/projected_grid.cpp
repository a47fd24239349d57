// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/projected_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace enfilade::explorer {
namespace {

constexpr int kMarginCells = 40;  ///< grown beyond what is asked for, so that growing is rare

}  // namespace

ProjectedGrid::ProjectedGrid(const ProjectedGridConfig& config) : config_(config) {
  if (!(config.obstacle_from_m < config.obstacle_to_m)) {
    throw std::invalid_argument("ProjectedGrid: obstacle_from_m must be below obstacle_to_m");
  }
  compute_masks();
}

void ProjectedGrid::clear() {
  columns_.clear();
  width_ = height_ = 0;
}

void ProjectedGrid::apply(double resolution_m, const std::vector<GridCell>& cells) {
  if (cells.empty()) return;
  if (columns_.empty() && resolution_m > 0.0) {
    resolution_m_ = resolution_m;
    compute_masks();
  }
  CellXY low{cells.front().x, cells.front().y}, high = low;
  for (const GridCell& c : cells) {
    low = {std::min<int>(low.x, c.x), std::min<int>(low.y, c.y)};
    high = {std::max<int>(high.x, c.x), std::max<int>(high.y, c.y)};
  }
  include(low, high);
  for (const GridCell& c : cells) {
    if (c.z < 0 || c.z >= kLayers) continue;
    Column& column = columns_[static_cast<std::size_t>((c.y - origin_.y) * width_ + c.x - origin_.x)];
    const std::uint64_t bit = std::uint64_t{1} << c.z;
    column.known = c.state == CellState::kUnexplored ? column.known & ~bit : column.known | bit;
    column.occupied = c.state == CellState::kOccupied ? column.occupied | bit : column.occupied & ~bit;
  }
}

CellState ProjectedGrid::state(int x, int y, int layer) const {
  const Column* column = find(x, y);
  if (!column || layer < 0 || layer >= kLayers || !(column->known >> layer & 1))
    return CellState::kUnexplored;
  return column->occupied >> layer & 1 ? CellState::kOccupied : CellState::kFree;
}

Floor ProjectedGrid::floor(CellXY cell) const {
  const Column* column = find(cell.x, cell.y);
  if (!column) return Floor::kUnexplored;
  if (column->occupied & obstacle_mask_) return Floor::kObstacle;
  return column->known & low_mask_ ? Floor::kFree : Floor::kUnexplored;
}

ProjectedGrid::Count ProjectedGrid::count(CellXY cell, double from_m, double to_m) const {
  const std::uint64_t mask = layers(from_m, to_m);
  const Column* column = find(cell.x, cell.y);
  if (!column) return {.unexplored = std::popcount(mask)};
  return {.free = std::popcount(mask & column->known & ~column->occupied),
          .occupied = std::popcount(mask & column->occupied),
          .unexplored = std::popcount(mask & ~column->known)};
}

CellXY ProjectedGrid::cell_at(const Point2& p) const {
  return {static_cast<int>(std::floor(p.x() / resolution_m_)),
          static_cast<int>(std::floor(p.y() / resolution_m_))};
}

int ProjectedGrid::layer_at(double z_m) const { return static_cast<int>(std::floor(z_m / resolution_m_)); }

const ProjectedGrid::Column* ProjectedGrid::find(int x, int y) const {
  x -= origin_.x;
  y -= origin_.y;
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return nullptr;
  return &columns_[static_cast<std::size_t>(y * width_ + x)];
}

void ProjectedGrid::include(CellXY low, CellXY high) {
  const bool inside = width_ > 0 && low.x >= origin_.x && low.y >= origin_.y && high.x < origin_.x + width_ &&
                      high.y < origin_.y + height_;
  if (inside) return;
  if (width_ > 0) {
    low = {std::min(low.x, origin_.x), std::min(low.y, origin_.y)};
    high = {std::max(high.x, origin_.x + width_ - 1), std::max(high.y, origin_.y + height_ - 1)};
  }
  const CellXY origin{low.x - kMarginCells, low.y - kMarginCells};
  const int width = high.x - origin.x + 1 + kMarginCells, height = high.y - origin.y + 1 + kMarginCells;
  std::vector<Column> grown(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height_; ++y) {
    const auto from = columns_.begin() + static_cast<std::ptrdiff_t>(y) * width_;
    const int to = (y + origin_.y - origin.y) * width + origin_.x - origin.x;
    std::copy(from, from + width_, grown.begin() + to);
  }
  columns_ = std::move(grown);
  origin_ = origin;
  width_ = width;
  height_ = height;
}

std::uint64_t ProjectedGrid::layers(double from_m, double to_m) const {
  // Layers of which the centre lies within from … to.
  const int first = std::max(0, static_cast<int>(std::ceil(from_m / resolution_m_ - 0.5)));
  const int last = std::min(kLayers - 1, static_cast<int>(std::floor(to_m / resolution_m_ - 0.5)));
  std::uint64_t mask = 0;
  for (int layer = first; layer <= last; ++layer) mask |= std::uint64_t{1} << layer;
  return mask;
}

void ProjectedGrid::compute_masks() {
  obstacle_mask_ = layers(config_.obstacle_from_m, config_.obstacle_to_m);
  low_mask_ = layers(0.0, config_.seen_below_m);
}

}  // namespace enfilade::explorer
