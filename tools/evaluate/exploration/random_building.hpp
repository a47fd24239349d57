// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "interfaces/geometry/pose2.hpp"

namespace enfilade::evaluate {

/// Inner faces of a room, building frame. Walls count from +x counter-clockwise, as in Rectangle.
struct BuiltRoom {
  Point2 low = Point2::Zero(), high = Point2::Zero();

  Point2 middle() const { return 0.5 * (low + high); }
  Point2 size() const { return high - low; }
};

struct BuiltOpening {
  std::size_t room = 0;
  int wall = 0;
  double middle_m = 0.0;  ///< along the building's x on walls 1 and 3, along its y on walls 0 and 2
  double width_m = 0.0;
};

struct BuiltDoor {
  BuiltOpening opening;
  double lintel_m = 2.03;
  std::optional<std::size_t> to;  ///< none: outside
};

struct BuiltWindow {
  BuiltOpening opening;
  double sill_m = 0.9;
  bool glass = true;
};

/// An upright box or cylinder that stands on the floor of a room.
struct BuiltThing {
  std::size_t room = 0;
  bool is_round = false;
  Point2 place = Point2::Zero();  ///< building frame
  Point2 size = Point2::Zero();   ///< along x and y before it is turned; both the diameter of a round one
  double height_m = 0.0;
  double yaw_rad = 0.0;
};

/// Somebody who walks up and down in a room.
struct BuiltWalker {
  std::size_t room = 0;
  std::array<Point2, 2> way{Point2::Zero(), Point2::Zero()};
  double speed_m_s = 0.6;
};

struct RandomBuilding {
  std::uint64_t seed = 0;
  double wall_m = 0.12;
  double ceiling_m = 2.6;
  Pose2 T_world_building;
  std::vector<BuiltRoom> rooms;
  std::vector<BuiltDoor> doors;
  std::vector<BuiltWindow> windows;
  std::vector<BuiltThing> furniture;
  std::vector<BuiltWalker> walkers;
  std::size_t start_room = 0;
  Pose2 T_building_start;
};

struct BuildingSpec {
  std::uint64_t seed = 1;
  int fewest_rooms = 2;
  int most_rooms = 8;
  double walkers = 0.0;  ///< probability that somebody walks in a room
  double blocked_doors =
      0.0;  ///< probability that something stands in a door, of those that close no room off
};

/// A furnished building of rectangular rooms, each of which can be reached from each other: a block cut into
/// rooms, half of the time with a corridor. The same seed gives the same building.
RandomBuilding random_building(const BuildingSpec& spec);

/// As a world file of the simulator.
std::string world_yaml(const RandomBuilding& building);

}  // namespace enfilade::evaluate
