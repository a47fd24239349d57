// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "interfaces/geometry/rectangle.hpp"
#include "tools/room/panorama.hpp"

namespace enfilade::room {

struct OutlineLimits {
  double side_min_m = 1.5, side_max_m = 15.0;
};

/// The most plausible of the rectangles about the robot whose sides lie on those of one of the `seeds` or on
/// straight surfaces that are parallel to them. Of equals the first, seeds before all others; empty without
/// seeds.
std::optional<Rectangle> choose_outline(const std::vector<Rectangle>& seeds, const Panorama& panorama,
                                        const OutlineLimits& limits);

}  // namespace enfilade::room
