// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "interfaces/geometry/pose2.hpp"
#include "interfaces/model/grid.hpp"

namespace enfilade::explorer {

/// A column of cells, floor(coordinate / resolution) as in GridCell.
struct CellXY {
  int x = 0, y = 0;

  bool operator==(const CellXY&) const = default;
};

/// What a column of cells means to a robot on the floor.
enum class Floor : std::uint8_t { kUnexplored = 0, kFree = 1, kObstacle = 2 };

struct ProjectedGridConfig {
  double obstacle_from_m = 0.05;  ///< an occupied cell above this height …
  double obstacle_to_m = 0.70;    ///< … and below this one is in the robot's way
  double seen_below_m = 0.25;     ///< a column is free only if it was seen free below this height
};

/// The zone's cells, one 64-bit pair per column: layer k covers k·r … (k + 1)·r over the floor, what is below
/// the floor or above layer 63 is not kept. From it the projection on the floor.
class ProjectedGrid {
 public:
  static constexpr int kLayers = 64;

  explicit ProjectedGrid(const ProjectedGridConfig& config);

  void clear();
  /// The resolution of the first message after clear() counts.
  void apply(double resolution_m, const std::vector<GridCell>& cells);

  double resolution_m() const { return resolution_m_; }
  bool empty() const { return columns_.empty(); }
  /// The known area: x in [origin().x, origin().x + width()), likewise y.
  CellXY origin() const { return origin_; }
  int width() const { return width_; }
  int height() const { return height_; }

  CellState state(int x, int y, int layer) const;
  Floor floor(CellXY cell) const;
  /// Of the layers from … to (m over the floor): how many are known and free, occupied, unexplored.
  struct Count {
    int free = 0, occupied = 0, unexplored = 0;
  };
  Count count(CellXY cell, double from_m, double to_m) const;

  CellXY cell_at(const Point2& p) const;
  Point2 centre(CellXY cell) const {
    return {(cell.x + 0.5) * resolution_m_, (cell.y + 0.5) * resolution_m_};
  }
  int layer_at(double z_m) const;

 private:
  struct Column {
    std::uint64_t known = 0, occupied = 0;
  };
  const Column* find(int x, int y) const;
  void include(CellXY low, CellXY high);
  std::uint64_t layers(double from_m, double to_m) const;
  void compute_masks();

  ProjectedGridConfig config_;
  double resolution_m_ = 0.05;
  std::uint64_t obstacle_mask_ = 0, low_mask_ = 0;
  CellXY origin_;
  int width_ = 0, height_ = 0;
  std::vector<Column> columns_;
};

}  // namespace enfilade::explorer
