// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "interfaces/geometry/rectangle.hpp"

namespace enfilade::explorer {

/// The same set of points with the sides renamed so that the yaw is the one of the four nearest to `yaw_rad`.
Rectangle named_towards(const Rectangle& r, double yaw_rad);

/// How far each wall of `a` is from the wall of `b` of the same name, at its middle and along the normal; `b`
/// is named towards `a`.
std::array<double, 4> wall_shifts_m(const Rectangle& a, const Rectangle& b);

}  // namespace enfilade::explorer
