// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "components/gridBuilder/core/cell_store.hpp"
#include "components/gridBuilder/core/hit_cells.hpp"

namespace enfilade::grid_builder {

struct ZoneGridConfig {
  double resolution_m = 0.05;  ///< side of a cell, 0.01 … 1
  double prob_hit = 0.7;       ///< P(occupied | one line hit the cell), 0.5 … 1
  double prob_miss = 0.4;      ///< P(occupied | one line passed through it), 0 … 0.5
  double clamp_min = 0.12;     ///< certainty of "free" grows no further than this, 0 … 0.5
  double clamp_max = 0.97;     ///< certainty of "occupied" grows no further than this, 0.5 … 1
  double occupied_from = 0.5;  ///< a cell is occupied from this probability on
  double max_range_m = 12.0;   ///< what lies farther from the sensor is carved up to here and never hit
  double min_height_m = -0.1;  ///< cells wholly within these heights over the floor exist, no others
  double max_height_m = 3.5;
  int max_memory_mb = 512;  ///< no tile is added beyond this; cells there stay unexplored
};

/// One line of the sensor in the zone frame. Lines of one stamp count as one line.
struct ScanLine {
  StampNs stamp_ns = 0;
  Point3f origin;                  ///< of the beams
  std::vector<Point3f> hits;       ///< where beams ended on a surface
  std::vector<Point3f> free_ends;  ///< up to where beams met nothing
};

/// What one line did to the grid.
struct LineUpdate {
  std::vector<GridCell>
      changes;                ///< cells of another state than before, with the new one; hits, then by beam
  std::vector<CellHit> hits;  ///< mean return per cell, sorted by cell
  std::size_t cells_without_memory = 0;
};

/// The local 3D occupancy grid of section II: occupied, free and unexplored cells whose certainty rises when
/// a point is seen again and falls when it vanishes.
///
/// Each line moves a cell's log-odds once, up if a beam ended in it and down if beams only passed through:
/// hits win over misses. The cells, the update rule and its constants are OctoMap's (Hornung et al. 2013,
/// insertPointCloud of one line), so that to_octree() is an exact copy; the dense store is what makes it
/// fast.
class ZoneGrid {
 public:
  explicit ZoneGrid(const ZoneGridConfig& config);

  LineUpdate insert(const ScanLine& line) { return insert(line, hit_cells(line)); }
  /// The returns of a line that count, by cell. They are known before the cells are worked on, which takes
  /// longer.
  std::vector<HitCell> hit_cells(const ScanLine& line) const;
  /// The same as insert(line), for whoever has asked for `hits` = hit_cells(line) already.
  LineUpdate insert(const ScanLine& line, const std::vector<HitCell>& hits);
  /// Everything becomes unexplored.
  void clear();

  CellState state(const CellIndex& cell) const;
  /// The certainty that the cell is occupied; nothing where it is unexplored.
  std::optional<double> probability(const CellIndex& cell) const;
  /// Every cell that is not unexplored, sorted.
  std::vector<GridCell> known_cells() const;
  CellIndex cell_at(const Point3f& point) const { return cell_of(to_vector(point) * cells_per_m_); }

  const ZoneGridConfig& config() const { return config_; }
  /// The cells of the tile that holds `cell`, in the order of offset_in_tile().
  std::array<CellState, kTileCells> tile_states(const CellIndex& cell) const;
  /// Visits the first cell of each tile, in no order to rely on.
  template <class Visit>
  void for_each_tile(Visit&& visit) const {
    cells_.for_each_tile(visit);
  }
  /// Visits the known cells and their log-odds, in no order to rely on.
  template <class Visit>
  void for_each_known(Visit&& visit) const {
    cells_.for_each_known(
        [&](const CellIndex& index, Cell cell) { visit(index, certainties_.log_odds(cell)); });
  }
  std::size_t tile_count() const { return cells_.tile_count(); }

 private:
  void begin_line(StampNs stamp_ns);
  void mark_hit(const CellIndex& cell, LineUpdate& update);
  void carve(const Point3f& origin, const Point3f& end, LineUpdate& update);
  void set(Tile& tile, std::size_t offset, Cell next, const CellIndex& index, LineUpdate& update);

  bool usable(const Point3f& origin, const Point3f& end) const;
  bool within_range(const Point3f& origin, const Point3f& end) const;
  bool within_height(const CellIndex& c) const { return c.z >= lowest_z_ && c.z <= highest_z_; }

  ZoneGridConfig config_;
  double cells_per_m_;
  double farthest_origin_;  ///< in cells, by each axis: one maximal range farther there still are cells
  int lowest_z_, highest_z_;
  CellStore cells_;
  Certainties certainties_;
  std::vector<Tile::Mark> touched_;  ///< by the line under way
  std::vector<CellIndex> hit_;       ///< by the line under way; sorted within each of its parts
  std::optional<StampNs> line_stamp_ns_;
};

}  // namespace enfilade::grid_builder
