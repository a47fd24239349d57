// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

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
/// "1 door", "2 doors".
std::string counted(long n, const std::string& thing);
/// "3.19 × 3.78 m, 2 doors, 12 % of the walls unseen".
std::string summary(const RoomEstimate& estimate);

}  // namespace enfilade::explorer
