// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/gridBuilder/core/waiting_lines.hpp"
#include "components/gridBuilder/core/zone_grid.hpp"

namespace enfilade::grid_builder {

/// The line as seen from the zone. The base stands on the floor: heights stay.
ScanLine place(const BaseLine& line, const Point3f& origin_base, const Pose2& T_zone_base);

}  // namespace enfilade::grid_builder
