// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/rectangle_naming.hpp"

#include <cmath>
#include <utility>

namespace enfilade::explorer {

Rectangle named_towards(const Rectangle& r, double yaw_rad) {
  const double rest_rad = wrap_to_quarter(r.yaw_rad - yaw_rad);
  const auto turns = static_cast<int>(std::lround(wrap_to_pi(r.yaw_rad - yaw_rad - rest_rad) / (0.5 * kPi)));
  Rectangle named = r;
  named.yaw_rad = wrap_to_pi(yaw_rad + rest_rad);
  if (turns % 2 != 0) std::swap(named.width_m, named.height_m);
  return named;
}

std::array<double, 4> wall_shifts_m(const Rectangle& a, const Rectangle& b) {
  const Rectangle named = named_towards(b, a.yaw_rad);
  std::array<double, 4> shifts{};
  for (int i = 0; i < 4; ++i) {
    shifts[static_cast<std::size_t>(i)] = (named.wall(i).midpoint() - a.wall(i).midpoint()).dot(a.normal(i));
  }
  return shifts;
}

}  // namespace enfilade::explorer
