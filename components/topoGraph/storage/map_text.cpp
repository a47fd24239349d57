// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_text.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>

#include "components/topoGraph/storage/map_names.hpp"

namespace enfilade::topo_graph {
namespace {

/// The shortest decimal that reads back as the same double.
std::string number(double value) {
  std::array<char, 32> digits{};
  const auto [end, error] = std::to_chars(digits.begin(), digits.end(), value);
  return {digits.begin(), end};
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      std::array<char, 8> escape{};
      std::snprintf(escape.data(), escape.size(), "\\x%02x", static_cast<unsigned>(c));
      out += escape.data();
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string pose(const Pose2& p) {
  return "{x_m: " + number(p.x_m) + ", y_m: " + number(p.y_m) + ", yaw_rad: " + number(p.yaw_rad) + "}";
}

std::string rectangle(const Rectangle& r) {
  return "{x_m: " + number(r.x_m) + ", y_m: " + number(r.y_m) + ", yaw_rad: " + number(r.yaw_rad) +
         ", width_m: " + number(r.width_m) + ", height_m: " + number(r.height_m) + "}";
}

std::string face(const DoorFace& f) {
  return "{room: " + std::to_string(f.room) + ", wall: " + std::to_string(f.gap.wall) +
         ", from_m: " + number(f.gap.from_m) + ", to_m: " + number(f.gap.to_m) +
         (f.position_sigma_m > 0.0 ? ", position_sigma_m: " + number(f.position_sigma_m) : "") +
         (f.measured_offset_m ? ", measured_offset_m: " + number(*f.measured_offset_m) : "") + "}";
}

template <class Items, class Write>
std::string list(const Items& items, Write&& write) {
  std::string out = "[";
  for (const auto& item : items) out += (out.size() > 1 ? ", " : "") + write(item);
  return out + "]";
}

template <class T>
std::string optional_id(const char* key, const std::optional<T>& id) {
  return id ? std::string("  ") + key + ": " + std::to_string(*id) + "\n" : std::string();
}

std::string answer_text(const Answer& answer) {
  return "    - {client: " + quoted(answer.call.client) + ", number: " + std::to_string(answer.call.number) +
         ", request: " + std::string(names::kRequestKinds.at(static_cast<std::size_t>(answer.kind))) +
         ", accepted: " + (answer.accepted ? "true" : "false") + ", message: " + quoted(answer.message) +
         ", id: " + std::to_string(answer.id) + "}\n";
}

std::string gap(const WallInterval& g) {
  return "{wall: " + std::to_string(g.wall) + ", from_m: " + number(g.from_m) + ", to_m: " + number(g.to_m) +
         "}";
}

/// The room of a closure has no id yet; the rest of it is written as any room, deeper.
std::string closure_text(const LoopClosure& closure) {
  Room room = closure.instead;
  room.id = 1;
  std::string lines = map_text::room(room), deeper;
  for (const char c : lines.substr(4)) {
    deeper += c;
    if (c == '\n') deeper += "    ";
  }
  deeper.resize(deeper.size() - 4);
  const RoomLink& link = closure.link;
  const auto id = [](DoorId door) { return std::to_string(door); };
  return "    - door: " + std::to_string(closure.door) + "\n      room: " + std::to_string(closure.room) +
         "\n      from: " + std::to_string(link.from) + "\n      T_from_to: " + pose(link.T_from_to) +
         "\n      sigma_position_m: " + number(link.sigma_position_m) +
         "\n      sigma_yaw_rad: " + number(link.sigma_yaw_rad) +
         "\n      entrance: " + gap(closure.entrance) + "\n      gaps: " + list(closure.gaps, gap) +
         "\n      added: " + list(closure.added, id) + "\n      instead:\n        " + deeper;
}

}  // namespace

std::string map_text::room(const Room& room) {
  std::string out = "  - id: " + std::to_string(room.id) + "\n    name: " + quoted(room.name) +
                    "\n    T_map_room: " + pose(room.T_map_room) + "\n    width_m: " + number(room.width_m) +
                    "\n    height_m: " + number(room.height_m) +
                    "\n    zone_id: " + std::to_string(room.zone_id) +
                    "\n    fixed_ns: " + std::to_string(room.fixed_ns) + "\n";
  if (room.measured_size_m)
    out += "    measured_size_m: [" + number(room.measured_size_m->x()) + ", " +
           number(room.measured_size_m->y()) + "]\n";
  if (room.seen_ns != 0) out += "    seen_ns: " + std::to_string(room.seen_ns) + "\n";
  if (room.T_room_base) out += "    T_room_base: " + pose(*room.T_room_base) + "\n";
  if (room.place != 0) out += "    place: " + std::to_string(room.place) + "\n";
  if (room.covariance) out += "    covariance_rad_m: " + list(*room.covariance, number) + "\n";
  const auto point = [](const Point2& p) { return "[" + number(p.x()) + ", " + number(p.y()) + "]"; };
  if (!room.polygon.empty()) out += "    polygon_m: " + list(room.polygon, point) + "\n";
  return out;
}

std::string map_text::door(const Door& door) {
  std::string out = "  - id: " + std::to_string(door.id) +
                    "\n    kind: " + std::string(names::kDoorKinds.at(static_cast<std::size_t>(door.kind))) +
                    "\n    face: " + face(door.face) + "\n";
  if (door.other_face) out += "    other_face: " + face(*door.other_face) + "\n";
  if (door.height_m) out += "    height_m: " + number(*door.height_m) + "\n";
  if (door.thickness_m) out += "    thickness_m: " + number(*door.thickness_m) + "\n";
  if (door.measured_thickness_m)
    out += "    measured_thickness_m: " + number(*door.measured_thickness_m) + "\n";
  if (door.driven) out += "    driven: true\n";
  if (door.closed) out += "    closed: true\n";
  return out;
}

std::string map_text::link(const RoomLink& link) {
  return "  - {from: " + std::to_string(link.from) + ", to: " + std::to_string(link.to) +
         ", T_from_to: " + pose(link.T_from_to) + ", sigma_position_m: " + number(link.sigma_position_m) +
         ", sigma_yaw_rad: " + number(link.sigma_yaw_rad) + "}\n";
}

std::string map_text::place(const Place& place) {
  return "  - {id: " + std::to_string(place.id) + ", parent: " + std::to_string(place.parent) +
         ", kind: " + std::string(names::kPlaceKinds.at(static_cast<std::size_t>(place.kind))) +
         ", name: " + quoted(place.name) + "}\n";
}

std::string map_text::session(const Session& session) {
  const CurrentZone& zone = session.zone;
  std::string out =
      "session:  # where the exploration stands\n  zone_id: " + std::to_string(zone.zone_id) + "\n";
  out += optional_id("room", zone.room) + optional_id("from_room", zone.from_room) +
         optional_id("via_door", zone.via_door);
  out += "  T_map_zone: " + pose(zone.T_map_zone) +
         "\n  valid_from_ns: " + std::to_string(zone.valid_from_ns) + "\n";
  if (!zone.located) out += "  located: false\n";
  if (session.reference) out += "  reference: " + rectangle(*session.reference) + "\n";
  out += "  reference_ns: " + std::to_string(session.reference_ns) + "\n" +
         optional_id("odom_boot", session.odom_boot);
  if (session.T_zone_base) out += "  T_zone_base: " + pose(*session.T_zone_base) + "\n";
  if (!session.closures.empty())
    out += "  closures:  # rooms taken for stored ones, and what they were modelled as\n";
  for (const LoopClosure& closure : session.closures) out += closure_text(closure);
  out += "  last_room: " + std::to_string(session.last_room) +
         "\n  last_door: " + std::to_string(session.last_door) + "\n";
  out += session.answers.empty() ? "  answers: []\n" : "  answers:\n";
  for (const Answer& answer : session.answers) out += answer_text(answer);
  return out;
}

}  // namespace enfilade::topo_graph
