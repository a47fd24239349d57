// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "interfaces/geometry/rectangle.hpp"

namespace enfilade {

/// x_m, y_m, yaw_rad, width_m, height_m: a rectangle as all reports tell it.
nlohmann::ordered_json rectangle_json(const Rectangle& rectangle);

}  // namespace enfilade
