// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "interfaces/model/counted.hpp"
#include "interfaces/model/room.hpp"

namespace enfilade::explorer {

/// With so many digits after the point.
std::string decimal(double value, int digits = 2);
/// "3.19 × 3.78 m".
std::string size_of(const Rectangle& r);
/// One of eight points of the compass; y is north.
std::string compass(double yaw_rad);
/// "(1.2, 0.4)".
std::string place_of(const Point2& p);
/// "3.19 × 3.78 m, 2 doors, 12 % of the walls unseen".
std::string summary(const RoomEstimate& estimate);

}  // namespace enfilade::explorer
