// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>

#include "components/gridBuilder/core/octree_stream.hpp"
#include "components/gridBuilder/core/zone_grid.hpp"
#include "interfaces/model/metric_map.hpp"

namespace enfilade::grid_builder {

struct ZonePicturesConfig {
  double floor_from_m = 0.1;      ///< an occupied cell between these heights stands on the floor map …
  double floor_to_m = 1.0;        ///< … and free ones alone make floor of it
  int max_floor_cells = 4000000;  ///< of the floor map; a larger one is cut off about the robot
};

/// The grid as others want it: an OctoMap, and its projection on the floor. Both are kept tile by tile, and
/// only tiles in which a cell has changed its state are looked at again: a few at a time, so that no line
/// waits for a whole hall. Holds nothing until follow().
class ZonePictures {
 public:
  explicit ZonePictures(const ZonePicturesConfig& config);

  /// From now on `note` counts; every tile is drawn anew.
  void follow(const ZoneGrid& grid);
  void stop_following();
  bool is_following() const { return follows_; }
  /// The grid was emptied.
  void clear();
  void note(const std::vector<GridCell>& changes);

  /// Draws up to `most` of the tiles that have changed; whether any are left.
  bool draw(const ZoneGrid& grid, std::size_t most);
  std::size_t left() const { return waiting_.size(); }

  /// As writeBinaryData of OctoMap gives it; empty where nothing is known.
  std::vector<std::int8_t> octree() const;
  /// Of the columns that are known, cut off about `robot` where they are too many. No stamp and no frame.
  OccupancyMap floor(double resolution_m, const Point2& robot) const;

 private:
  /// Columns of a tile as far as they lie between the heights that count.
  using Floor = std::array<CellState, kTileSide * kTileSide>;

  bool touches_floor(int first_z, double resolution_m) const;
  Floor draw_floor(const TileStates& states, int first_z, double resolution_m) const;

  ZonePicturesConfig config_;
  bool follows_ = false;
  std::set<StreamKey> waiting_;
  std::map<StreamKey, PackedTile> tiles_;
  std::map<StreamKey, Floor> floors_;
};

}  // namespace enfilade::grid_builder
