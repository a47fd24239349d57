// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "interfaces/model/transform.hpp"

namespace enfilade {

/// Cells on the floor, as ROS 2 draws them (rt/map, rt/local_map): row by row, the lowest y first.
struct OccupancyMap {
  static constexpr std::int8_t kUnknown = -1, kFree = 0, kOccupied = 100;

  StampNs stamp_ns = 0;
  std::string frame_id;
  float resolution_m = 0.0F;
  std::uint32_t columns = 0, rows = 0;
  Transform3 T_frame_cells;  ///< to the outer corner of the first cell
  std::vector<std::int8_t> cells;

  bool operator==(const OccupancyMap&) const = default;
};

/// Cells in space, as OctoMap packs them (rt/octomap): free, occupied or unknown. `data` is what
/// octomap::OcTree::writeBinaryData writes.
struct OctreeMap {
  StampNs stamp_ns = 0;
  std::string frame_id;
  double resolution_m = 0.0;
  std::vector<std::int8_t> data;

  bool operator==(const OctreeMap&) const = default;
};

}  // namespace enfilade
