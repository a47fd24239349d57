// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interfaces/model/room.hpp"
#include "tools/simulator/core/world.hpp"

namespace enfilade::simulator {

/// What a person writes in a world file. Coordinates are in the building's frame; those of things inside a
/// room have already been taken from the room's frame to the building's. Every item remembers the line it was
/// read from.
struct PlanRoom {
  std::string name;
  Rectangle rectangle;  ///< inner faces
  double ceiling_m = 2.6;
  int line = 0;
};

/// A hole in the wall of a room. `wall` and `middle_m` (from the wall's first corner) follow Rectangle.
struct PlanOpening {
  std::size_t room = 0;
  int wall = 0;
  double middle_m = 0.0;
  double width_m = 0.0;
  double bottom_m = 0.0;
  double top_m = 0.0;
  int line = 0;
};

struct PlanDoor {
  PlanOpening opening;
  std::optional<std::size_t> to;  ///< none: outside
};

struct PlanWindow {
  PlanOpening opening;
  bool glass = true;
};

struct FloorPlan {
  std::string name;
  Pose2 T_world_building;
  double wall_thickness_m = 0.12;
  bool ground = true;  ///< whether there is ground outside the rooms
  std::vector<PlanRoom> rooms;
  std::vector<PlanDoor> doors;
  std::vector<PlanWindow> windows;
  std::vector<Solid> furniture;
  std::vector<MovingSolid> moving;
  Pose2 T_building_start;
};

/// The wall of the other room that a passage also cuts, and how thick the wall is between the two inner
/// faces.
struct FacingWall {
  WallInterval gap;
  double depth_m = 0.0;
};

/// The inner-face segment of an opening.
Segment face(const FloorPlan& plan, const PlanOpening& opening);

/// Where a passage comes out in the room it leads to; none where that room has no wall right behind.
std::optional<FacingWall> facing_wall(const FloorPlan& plan, const PlanDoor& door);

/// A problem and the line of the item that has it.
struct PlanProblem {
  int line = 0;
  std::string what;
};

/// Everything that keeps the plan from being built, in sentences that say what to do.
std::vector<PlanProblem> problems(const FloorPlan& plan);

/// Needs a plan without problems. A wall slab stands outside every room outline; each opening cuts every slab
/// it crosses.
World build_world(const FloorPlan& plan);

}  // namespace enfilade::simulator
