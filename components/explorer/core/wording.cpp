// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/wording.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "components/explorer/core/stability_test.hpp"

namespace enfilade::explorer {

std::string decimal(double value, int digits) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

std::string size_of(const Rectangle& r) { return decimal(r.width_m) + " × " + decimal(r.height_m) + " m"; }

std::string compass(double yaw_rad) {
  static constexpr std::array<const char*, 8> kPoints{"east", "north-east", "north", "north-west",
                                                      "west", "south-west", "south", "south-east"};
  const long eighth = std::lround(yaw_rad / (0.25 * kPi));
  return kPoints[static_cast<std::size_t>((eighth % 8 + 8) % 8)];
}

std::string place_of(const Point2& p) { return "(" + decimal(p.x(), 1) + ", " + decimal(p.y(), 1) + ")"; }

std::string summary(const RoomEstimate& estimate) {
  return size_of(estimate.rectangle) + ", " + counted(count_open_doors(estimate), "door") + ", " +
         decimal(100.0 * estimate.unexplored_wall_share, 0) + " % of the walls unseen";
}

}  // namespace enfilade::explorer
