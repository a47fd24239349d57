// SPDX-License-Identifier: Apache-2.0
#include "tools/support/rectangle_json.hpp"

namespace enfilade {

nlohmann::ordered_json rectangle_json(const Rectangle& r) {
  return {{"x_m", r.x_m},
          {"y_m", r.y_m},
          {"yaw_rad", r.yaw_rad},
          {"width_m", r.width_m},
          {"height_m", r.height_m}};
}

}  // namespace enfilade
