// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include <fmt/format.h>

#include "components/topoGraph/exports/export_parts.hpp"
#include "components/topoGraph/metric_map/map_formats.hpp"
#include "components/topoGraph/storage/map_file.hpp"
#include "interfaces/model/counted.hpp"
#include "tools/enfilade/map/map_commands.hpp"

namespace enfilade::map_tool {
namespace {

std::string room_line(const TopologicalMap& map, const Room& room) {
  int doors = 0;
  for (const Door& door : map.doors) doors += TopologicalMap::find_face(door, room.id) != nullptr;
  return fmt::format("{:>6}  {:<20} {:>7.2f} × {:<7.2f} {:>9.2f} {:>9.2f} {:>8.2f} {:>6}\n", room.id,
                     room.name, room.width_m, room.height_m, room.T_map_room.x_m, room.T_map_room.y_m,
                     degrees(room.T_map_room.yaw_rad), doors);
}

std::string door_line(const TopologicalMap& map, const Door& door) {
  const Point2 at = topo_graph::exports::middle(map, door.face);
  const std::string other = door.other_face ? std::to_string(door.other_face->room) : "-";
  return fmt::format("{:>6}  {:<10} {:>6} {:>6} {:>8.2f} {:>9.2f} {:>9.2f}{}\n", door.id,
                     topo_graph::exports::kind_name(door.kind), door.face.room, other,
                     door.face.gap.width_m(), at.x(), at.y(), door.closed ? "  closed" : "");
}

/// The paper's point: no dense map beside the graph.
std::string memory_line(const std::string& file, const TopologicalMap& map) {
  const double rooms = static_cast<double>(map.rooms.size());
  const double graph = static_cast<double>(std::filesystem::file_size(file));
  const auto dense = topo_graph::to_octomap(topo_graph::draw_metric_map(map, {}));
  return fmt::format(
      "memory: {:.0f} bytes a room in this file; {:.0f} in an OctoMap (.bt) of 0.05 m of the same rooms\n",
      graph / rooms, static_cast<double>(dense.size()) / rooms);
}

}  // namespace

std::string show(const std::string& file) {
  const TopologicalMap map = topo_graph::load_map(file);
  double area_m2 = 0.0;
  for (const Room& room : map.rooms) area_m2 += room.rectangle().area_m2();
  std::string text =
      fmt::format("{}: {}, {}, {:.1f} m², version {}\n", file, counted(map.rooms.size(), "room"),
                  counted(map.doors.size(), "door"), area_m2, map.version);
  for (const Place& place : map.places)
    text += fmt::format("{} {}: {}\n", place.kind == PlaceKind::kBuilding ? "building" : "floor", place.id,
                        place.name);
  if (!map.rooms.empty())
    text += fmt::format("{:>6}  {:<20} {:>7} × {:<7} {:>9} {:>9} {:>8} {:>6}\n", "room", "name", "width m",
                        "height m", "x m", "y m", "yaw °", "doors");
  for (const Room& room : map.rooms) text += room_line(map, room);
  if (!map.doors.empty())
    text += fmt::format("{:>6}  {:<10} {:>6} {:>6} {:>8} {:>9} {:>9}\n", "door", "kind", "room", "to",
                        "width m", "x m", "y m");
  for (const Door& door : map.doors) text += door_line(map, door);
  if (!map.rooms.empty()) text += memory_line(file, map);
  return text;
}

}  // namespace enfilade::map_tool
