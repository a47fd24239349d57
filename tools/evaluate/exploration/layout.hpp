// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/evaluate/exploration/dice.hpp"
#include "tools/evaluate/exploration/random_building.hpp"

namespace enfilade::evaluate {

/// Cuts a block into rooms, walls `building.wall_m` thick between them.
void lay_out_rooms(const BuildingSpec& spec, Dice& dice, RandomBuilding& building);

/// Doors that join all rooms, some more, and some to the outside; windows in outer walls.
void lay_out_openings(const BuildingSpec& spec, Dice& dice, RandomBuilding& building);

/// Furniture among which a robot still gets from door to door, and where it starts.
void furnish(const BuildingSpec& spec, Dice& dice, RandomBuilding& building);

}  // namespace enfilade::evaluate
