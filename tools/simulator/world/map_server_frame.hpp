// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "interfaces/geometry/pose2.hpp"
#include "interfaces/model/grid.hpp"
#include "tools/simulator/world/yaml_fields.hpp"

namespace enfilade::simulator {

/// What a map_server YAML says of its image.
struct MapServerFrame {
  std::string image;  ///< file
  double resolution_m = 0.05;
  Pose2 T_map_corner;  ///< lower left corner of the lower left pixel
  bool negate = false;
  double occupied_from = 0.65, free_below = 0.196;

  /// As map_server has it: p = (255 - pixel) / 255, or pixel / 255 when negated; occupied where p exceeds the
  /// upper threshold, free where it is below the lower one.
  CellState state_of(std::uint8_t pixel) const;
};

/// The image is looked for in `folder`, and the origin lies at most `farthest_m` away along each axis. What
/// is wrong goes to the problems of `fields`; keys that others read are left alone.
MapServerFrame read_map_server_frame(YamlFields& fields, const std::string& folder, double farthest_m);

}  // namespace enfilade::simulator
