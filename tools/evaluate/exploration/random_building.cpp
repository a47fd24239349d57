// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/exploration/random_building.hpp"

#include <array>

#include <fmt/format.h>

#include "tools/evaluate/exploration/layout.hpp"

namespace enfilade::evaluate {
namespace {

constexpr std::array<const char*, 4> kWallNames{"east", "north", "west", "south"};

/// Room, wall and place along it as a world file has them.
std::string opening_fields(const RandomBuilding& building, const BuiltOpening& o) {
  const double offset_m = o.middle_m - building.rooms[o.room].middle()[1 - o.wall % 2];
  return fmt::format("room: r{}, wall: {}, offset_m: {:.4f}, width_m: {:.4f}", o.room + 1,
                     kWallNames[static_cast<std::size_t>(o.wall)], offset_m, o.width_m);
}

std::string room_lines(const RandomBuilding& building) {
  std::string out = "rooms:\n";
  for (std::size_t i = 0; i < building.rooms.size(); ++i) {
    const BuiltRoom& room = building.rooms[i];
    out += fmt::format("  - {{name: r{}, x_m: {:.9f}, y_m: {:.9f}, width_m: {:.9f}, height_m: {:.9f}}}\n",
                       i + 1, room.middle().x(), room.middle().y(), room.size().x(), room.size().y());
  }
  return out;
}

std::string door_lines(const RandomBuilding& building) {
  std::string out = "doors:\n";
  for (const BuiltDoor& door : building.doors) {
    out += fmt::format("  - {{{}, lintel_m: {:.3f}, to: {}}}\n", opening_fields(building, door.opening),
                       door.lintel_m, door.to ? fmt::format("r{}", *door.to + 1) : "outside");
  }
  return out;
}

std::string window_lines(const RandomBuilding& building) {
  std::string out = "windows:\n";
  for (const BuiltWindow& window : building.windows) {
    out += fmt::format("  - {{{}, sill_m: {:.3f}, top_m: 2.1, glass: {}}}\n",
                       opening_fields(building, window.opening), window.sill_m, window.glass);
  }
  return building.windows.empty() ? "" : out;
}

std::string furniture_lines(const RandomBuilding& building) {
  std::string out = "furniture:\n";
  for (const BuiltThing& thing : building.furniture) {
    const std::string shape =
        thing.is_round
            ? fmt::format("cylinder_m: [{:.3f}, {:.3f}]", thing.size.x(), thing.height_m)
            : fmt::format("box_m: [{:.3f}, {:.3f}, {:.3f}]", thing.size.x(), thing.size.y(), thing.height_m);
    out += fmt::format("  - {{name: thing, {}, x_m: {:.4f}, y_m: {:.4f}, yaw_deg: {:.2f}}}\n", shape,
                       thing.place.x(), thing.place.y(), degrees(thing.yaw_rad));
  }
  return building.furniture.empty() ? "" : out;
}

std::string walker_lines(const RandomBuilding& building) {
  std::string out = "moving:\n";
  for (const BuiltWalker& walker : building.walkers) {
    out += fmt::format(
        "  - {{name: person, cylinder_m: [0.45, 1.75], speed_m_s: {:.2f}, waypoints_m: [[{:.3f}, {:.3f}], "
        "[{:.3f}, {:.3f}]]}}\n",
        walker.speed_m_s, walker.way[0].x(), walker.way[0].y(), walker.way[1].x(), walker.way[1].y());
  }
  return building.walkers.empty() ? "" : out;
}

}  // namespace

RandomBuilding random_building(const BuildingSpec& spec) {
  Dice dice(spec.seed);
  RandomBuilding building{.seed = spec.seed};
  building.wall_m = dice.between(0.10, 0.25);
  building.ceiling_m = dice.between(2.4, 3.0);
  building.T_world_building = {dice.between(-5.0, 5.0), dice.between(-5.0, 5.0), dice.between(-kPi, kPi)};
  lay_out_rooms(spec, dice, building);
  lay_out_openings(spec, dice, building);
  furnish(spec, dice, building);
  return building;
}

std::string world_yaml(const RandomBuilding& building) {
  const Pose2 &T = building.T_world_building, &start = building.T_building_start;
  std::string out = fmt::format(
      "# SPDX-License-Identifier: Apache-2.0\nname: random building {}\nbuilding: {{x_m: {:.3f}, y_m: "
      "{:.3f}, "
      "yaw_deg: {:.3f}}}\nwall_thickness_m: {:.9f}\nceiling_m: {:.3f}\n",
      building.seed, T.x_m, T.y_m, degrees(T.yaw_rad), building.wall_m, building.ceiling_m);
  out += room_lines(building) + door_lines(building) + window_lines(building) + furniture_lines(building) +
         walker_lines(building);
  return out + fmt::format("start: {{x_m: {:.4f}, y_m: {:.4f}, yaw_deg: {:.2f}}}\n", start.x_m, start.y_m,
                           degrees(start.yaw_rad));
}

}  // namespace enfilade::evaluate
