// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/roomDetector/core/column_map.hpp"

namespace enfilade::room_detector {

enum class BandChoice { kAuto, kAll, kUpper };

struct WallBandConfig {
  BandChoice band = BandChoice::kAuto;  ///< kAll: the paper's; kUpper: above furniture; kAuto: upper where it
                                        ///< holds enough returns, or else the top of low walls
  double wall_band_from_m = 2.05;       ///< the upper band: above cupboards and door lintels …
  double wall_band_to_m = 2.5;          ///< … and below the ceiling
  double floor_margin_m = 0.15;         ///< cells lower than this are floor
  double ceiling_margin_m = 0.10;       ///< so much below the ceiling's layer is ceiling too
};

/// The heights whose cells vote for walls: levels from ≤ l < to.
struct WallBand {
  int from = 0;
  int to = 0;
  bool above_furniture = false;

  Levels levels() const { return level_range(from, to); }
  int size() const { return to - from; }
  bool operator==(const WallBand&) const = default;
};

/// The lowest level of the ceiling's layer: the fullest layer above 1.8 m, if it holds far more cells than
/// the layers of the walls do. A plane parallel to the floor fills its layer with an area, a wall only with
/// its outline.
std::optional<int> find_ceiling(const ColumnMap& map);

WallBand choose_wall_band(const ColumnMap& map, const WallBandConfig& config);

}  // namespace enfilade::room_detector
