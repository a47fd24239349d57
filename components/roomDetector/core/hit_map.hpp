// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "components/roomDetector/core/wall_band.hpp"
#include "interfaces/model/grid.hpp"

namespace enfilade::room_detector {

/// A point that a wall may be fitted to, and how many measurements stand behind it.
struct WallPoint {
  Point2 position = Point2::Zero();
  double weight = 1.0;
  Point2 per_range = Point2::Zero();  ///< how the position moves with a longer range; zero = not known
};

/// Returns of the laser, summed up by cell. Every return counts, whether or not its cell is occupied by now:
/// those on the near side of a noisy wall lie in cells that other rays carve away, and leaving them out would
/// move the wall outwards.
class HitMap {
 public:
  /// Sum of the returns of one cell.
  struct Sum {
    std::uint64_t key = 0;
    int level = 0;
    double x_m = 0.0, y_m = 0.0, z_m = 0.0, count = 0.0;
  };

  void clear();
  /// `cell_m` is the side of the upright cells the returns are summed in, `resolution_m` their height: a
  /// level. Returns that are not finite, or too far away to be counted, are passed over.
  void add(const std::vector<CellHit>& hits, double resolution_m, double cell_m);
  void add(const std::vector<CellHit>& hits, double resolution_m) { add(hits, resolution_m, resolution_m); }
  /// Adds the cells of another map with the same cells.
  void add(const HitMap& other);

  bool empty() const { return cells_.empty(); }
  std::uint64_t count() const { return count_; }
  /// Mean positions of the returns in the cells of a band of heights.
  std::vector<WallPoint> points(const WallBand& band) const { return points(band.from, band.to); }
  std::vector<WallPoint> points(int from_level, int to_level) const;
  /// Calls visit(mean position, count) for every cell.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (const Sum& cell : cells_) visit(Point2(cell.x_m / cell.count, cell.y_m / cell.count), cell.count);
  }
  /// The returns of the levels, summed up by upright column, in the order of first sight.
  std::vector<Sum> columns(int from_level, int to_level) const;

 private:
  Sum& cell_at(std::uint64_t key, int level);
  void grow();

  std::vector<std::uint32_t> slots_;  // 1 + index into cells_, by hash of the key; 0 = none
  std::vector<Sum> cells_;  // in the order of first sight, so that sums come out the same every time
  std::uint64_t count_ = 0;
};

}  // namespace enfilade::room_detector
