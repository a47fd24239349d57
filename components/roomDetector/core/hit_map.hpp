// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <deque>
#include <vector>

#include "components/roomDetector/core/convex_region.hpp"
#include "components/roomDetector/core/keyed_table.hpp"
#include "components/roomDetector/core/point_mover.hpp"
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
  /// Sum of the returns of some cells.
  struct Sum {
    double x_m = 0.0, y_m = 0.0, z_m = 0.0, count = 0.0;
  };

  void clear();
  /// `cell_m` is the side of the upright cells the returns are summed in, `resolution_m` their height: a
  /// level. Returns that are not finite, or too far away to be counted, are passed over.
  void add(const std::vector<CellHit>& hits, double resolution_m, double cell_m);
  void add(const std::vector<CellHit>& hits, double resolution_m) { add(hits, resolution_m, resolution_m); }
  /// Adds the cells of another map with the same cells.
  void add(const HitMap& other);

  bool empty() const { return cells_.entries().empty(); }
  std::uint64_t count() const { return count_; }
  /// Mean positions of the returns in the cells of a band of heights.
  std::vector<WallPoint> points(const WallBand& band) const { return points(band.from, band.to); }
  std::vector<WallPoint> points(int from_level, int to_level) const;
  /// Calls visit(mean position, count) for one cell after the other whose mean position the region contains,
  /// while that returns true. `T_map_hits` is where the returns are in the frame of region and position.
  template <class Visit>
  void visit_within(const ConvexRegion& region, const Pose2& T_map_hits, Visit&& visit) const {
    const PointMover move(T_map_hits);
    for (const Block& block : blocks_.entries()) {
      if (!region.may_meet(move(centre_of(block)), block_radius_m())) continue;
      for (const std::uint32_t i : block.cells) {
        const Sum sum = sum_of(cells_.entries()[i]);
        const Point2 at = move({sum.x_m / sum.count, sum.y_m / sum.count});
        if (region.contains(at) && !visit(at, sum.count)) return;
      }
    }
  }
  /// Sum of the returns in the cells of one upright column.
  struct Upright {
    std::uint64_t key = 0;
    Sum sum;
  };
  /// From now on the returns at the heights of the band are kept by upright column, too.
  void follow(const WallBand& band);
  /// Those of the band, in the order of first sight.
  const std::deque<Upright>& columns() const { return columns_.entries(); }

 private:
  /// What its returns add up to, counted from its lower corner: a zone holds hundreds of thousands of cells,
  /// and small numbers lose nothing as floats.
  struct Cell {
    std::uint64_t key = 0;
    float x_m = 0.0F, y_m = 0.0F, z_m = 0.0F;
    std::uint32_t count = 0;
  };
  /// The lower corner of a cell, in cells.
  struct Corner {
    int x, y, z;
  };

  /// The cells over a square of the floor, so that those of one place are found without going through all.
  struct Block {
    std::uint64_t key = 0;
    std::vector<std::uint32_t> cells = {};
  };

  static Corner corner_of(std::uint64_t key);
  static std::uint64_t key_of(const Corner& corner);
  Sum sum_of(const Cell& cell) const;
  static bool is_within(const Cell& cell, int from_level, int to_level);
  int cells_per_block() const;
  Point2 centre_of(const Block& block) const;
  double block_radius_m() const { return std::sqrt(0.5) * cells_per_block() * cell_m_; }
  void add(const Cell& more);
  void add_to_block(std::uint64_t key);
  void add_to_column(const Cell& more);

  double cell_m_ = 0.0, resolution_m_ = 0.0;
  KeyedTable<Cell> cells_;  // in the order of first sight, so that sums come out the same every time
  KeyedTable<Block> blocks_;
  WallBand followed_{0, 0, false};
  KeyedTable<Upright> columns_;
  std::uint64_t count_ = 0;
};

/// Returns, and where they are in the frame of the map.
struct PlacedHits {
  const HitMap* hits;
  Pose2 T_map_hits = {};
};

}  // namespace enfilade::room_detector
