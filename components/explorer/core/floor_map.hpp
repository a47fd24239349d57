// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "components/explorer/core/projected_grid.hpp"

namespace enfilade::explorer {

/// What the robot knows about the floor besides the grid.
struct FloorHints {
  std::vector<Point2> trodden;    ///< where its centre has been: the floor under it is free
  std::vector<Point2> obstacles;  ///< seen lately, and perhaps not in the grid
  std::vector<Point2> passing;    ///< in the grid, and known not to stand there
};

struct FloorMapConfig {
  double body_radius_m =
      0.24;  ///< what was seen this close to where the robot was is not there: the robot is
  double trodden_radius_m = 0.40;  ///< unexplored floor this close to where the robot was counts as free
};

/// A still picture of the floor for planning: what each cell is, and how far the nearest obstacle and the
/// nearest unexplored cell are. Single unexplored cells amid free ones count as free.
class FloorMap {
 public:
  FloorMap(const ProjectedGrid& grid, const FloorHints& hints, const FloorMapConfig& config);

  /// The same floor with each cell cut into 3 × 3, so that a place is known three times as finely. Distances
  /// stay those to the centres of the uncut cells.
  FloorMap refined() const;

  int width() const { return width_; }
  int height() const { return height_; }
  double resolution_m() const { return resolution_m_; }
  bool contains(CellXY c) const {
    return c.x >= origin_.x && c.y >= origin_.y && c.x < origin_.x + width_ && c.y < origin_.y + height_;
  }
  std::size_t index(CellXY c) const {
    return static_cast<std::size_t>(c.y - origin_.y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(c.x - origin_.x);
  }
  CellXY cell(std::size_t index) const {
    const int i = static_cast<int>(index);
    return {origin_.x + i % width_, origin_.y + i / width_};
  }
  CellXY cell_at(const Point2& p) const;
  Point2 centre(CellXY c) const { return {(c.x + 0.5) * resolution_m_, (c.y + 0.5) * resolution_m_}; }

  Floor floor(CellXY c) const { return contains(c) ? cells_[index(c)] : Floor::kUnexplored; }
  /// Distance between cell centres; 0 outside the map.
  double to_obstacle_m(CellXY c) const { return contains(c) ? to_obstacle_m_[index(c)] : 0.0; }
  double to_unexplored_m(CellXY c) const { return contains(c) ? to_unexplored_m_[index(c)] : 0.0; }

 private:
  void tread(const Point2& p, const FloorMapConfig& config);
  void fill_holes();
  std::vector<float> distance_to(Floor what) const;
  std::vector<float> distance_to_uncut(Floor what) const;
  std::vector<float> distance_to(const std::vector<std::uint8_t>& set) const;

  CellXY origin_;
  int width_, height_;
  double resolution_m_;
  std::vector<Floor> cells_;
  std::vector<float> to_obstacle_m_, to_unexplored_m_;
};

}  // namespace enfilade::explorer
