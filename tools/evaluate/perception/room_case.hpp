// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "tools/simulator/core/floor_plan.hpp"

namespace enfilade::evaluate {

/// What makes a room harder than the furnished one (furniture up to 2.0 m).
enum class Hardship { kNone, kLowWalls, kCupboards, kGlass, kPeople, kCollinear };

/// A random building about one room: what was built, and where the robot stands in it.
struct RoomCase {
  simulator::World world;
  Rectangle room;                          ///< inner faces, world frame
  std::vector<simulator::TrueDoor> doors;  ///< of that room
  Pose2 T_world_base;                      ///< the robot's place in the room …
  Pose2 T_world_neighbour;                 ///< … and one in the room next door
};

/// The room has two or three doors, most of the time a window, a corridor along one side and a neighbour on
/// the other; kCollinear: two walls of the neighbour prolong those of the room.
RoomCase make_room_case(std::uint64_t seed, Hardship hardship);

}  // namespace enfilade::evaluate
