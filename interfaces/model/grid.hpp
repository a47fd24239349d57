// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "interfaces/geometry/pose2.hpp"
#include "interfaces/model/zone_tag.hpp"

namespace enfilade {

enum class CellState : std::uint8_t { kUnexplored = 0, kFree = 1, kOccupied = 2 };

/// A cell of the zone's grid: its centre is at ((x + ½) r, (y + ½) r, (z + ½) r) in the zone frame, r the
/// resolution. z = 0 lies on the floor.
struct GridCell {
  std::int16_t x = 0, y = 0, z = 0;
  CellState state = CellState::kUnexplored;

  bool operator==(const GridCell&) const = default;
};

/// Cells whose state changed. `sequence` counts 1, 2, 3 … within an epoch; a reader that misses one asks for
/// a snapshot. A snapshot is the same message with every cell that is not unexplored and the sequence it
/// includes.
struct GridChange {
  ZoneTag tag;
  std::uint64_t sequence = 0;
  StampNs stamp_ns = 0;  ///< of the newest scan line included
  double resolution_m = 0.0;
  std::vector<GridCell> cells;

  bool operator==(const GridChange&) const = default;
};

/// Mean of the returns that fell into one cell during one scan line, zone frame.
struct CellHit {
  float x_m = 0, y_m = 0, z_m = 0;
  std::uint16_t count = 0;

  bool operator==(const CellHit&) const = default;
};

/// What one scan line hit, whether or not it changed a cell: the "recently perceived points" of section IV.
struct ScanHits {
  ZoneTag tag;
  StampNs stamp_ns = 0;
  Pose2 T_zone_base;  ///< where the line was taken from
  std::vector<CellHit> hits;

  bool operator==(const ScanHits&) const = default;
};

}  // namespace enfilade
