// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/gridBuilder/core/wall_alignment.hpp"
#include "interfaces/model/room.hpp"

namespace enfilade::grid_builder {

/// The room's walls; those less sure than `max_sigma_m` have not been seen. An estimate without a covariance
/// does not tell: all count as seen.
KnownWalls known_walls(const RoomEstimate& estimate, double max_sigma_m);

}  // namespace enfilade::grid_builder
