// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/exports/export_parts.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "components/topoGraph/exports/exports.hpp"

namespace enfilade::topo_graph {
namespace exports {

std::string_view kind_name(DoorKind kind) {
  constexpr std::array<std::string_view, 4> kNames{"unresolved", "passage", "exit", "blocked"};
  return kNames.at(static_cast<std::size_t>(kind));
}

std::string room_name(const Room& room) {
  return room.name.empty() ? "room " + std::to_string(room.id) : room.name;
}

std::vector<Point2> outline(const Room& room) {
  const auto corners = room.rectangle().corners();
  if (room.polygon.size() < 3) return {corners.begin(), corners.end()};
  std::vector<Point2> points;
  double doubled_area = 0.0;
  for (std::size_t i = 0; i < room.polygon.size(); ++i) {
    const Point2 &a = room.polygon[i], &b = room.polygon[(i + 1) % room.polygon.size()];
    doubled_area += a.x() * b.y() - a.y() * b.x();
    points.push_back(room.T_map_room * a);
  }
  if (doubled_area < 0.0) std::reverse(points.begin(), points.end());
  return points;
}

Point2 middle(const TopologicalMap& map, const DoorFace& face) {
  return segment_in_map(*map.find_room(face.room), face).midpoint();
}

std::string xml(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += control ? '?' : c;
  }
  return out;
}

double walk_m(const TopologicalMap& map, const Door& door) {
  const Point2 near = middle(map, door.face);
  const double first_m = (near - map.find_room(door.face.room)->T_map_room.translation()).norm();
  if (!door.other_face) return first_m;
  const Point2 far = middle(map, *door.other_face);
  return first_m + (far - near).norm() +
         (far - map.find_room(door.other_face->room)->T_map_room.translation()).norm();
}

}  // namespace exports

TopologicalMap part_of(const TopologicalMap& map, const std::vector<RoomId>& rooms) {
  if (rooms.empty()) return map;
  const auto chosen = [&rooms](RoomId id) {
    return std::find(rooms.begin(), rooms.end(), id) != rooms.end();
  };
  for (const RoomId id : rooms)
    if (!map.find_room(id))
      throw std::invalid_argument("there is no room " + std::to_string(id) + " in the map");
  TopologicalMap part{.version = map.version, .stamp_ns = map.stamp_ns, .places = map.places};
  for (const Room& room : map.rooms)
    if (chosen(room.id)) part.rooms.push_back(room);
  for (Door door : map.doors) {
    const bool first = chosen(door.face.room), second = door.other_face && chosen(door.other_face->room);
    if (!first && !second) continue;
    if (!first) door.face = *door.other_face;
    if (door.other_face && !(first && second)) {
      door.other_face.reset();
      if (door.kind == DoorKind::kPassage) door.kind = DoorKind::kUnresolved;
    }
    part.doors.push_back(door);
  }
  for (const RoomLink& link : map.links)
    if (chosen(link.from) && chosen(link.to)) part.links.push_back(link);
  return part;
}

}  // namespace enfilade::topo_graph
