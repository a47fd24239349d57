// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "interfaces/model/counted.hpp"
#include "tools/draw/figures.hpp"
#include "tools/draw/svg.hpp"
#include "tools/draw/wall_place.hpp"

namespace enfilade::draw {
namespace {

constexpr double kPlanPixelsPerMetre = 80.0;
constexpr double kDimension_px = 12.0;
constexpr double kDoorText_px = 11.0;
const Paint kPlanWall{.stroke = "#37474f", .width_px = 5.0, .fill = "#fafafa"};
const Paint kPassage{.stroke = "#2e9e3f", .width_px = 7.0};
const Paint kExit{.stroke = "#ef6c00", .width_px = 7.0};
const Paint kUnresolved{.stroke = "#9e9e9e", .width_px = 7.0};
const Paint kShut{.stroke = "#c62828", .width_px = 7.0};

bool is_shut(const Door& door) { return door.closed || door.kind == DoorKind::kBlocked; }

const Paint& paint_of(const Door& door) {
  if (is_shut(door)) return kShut;
  if (door.kind == DoorKind::kPassage) return kPassage;
  return door.kind == DoorKind::kExit ? kExit : kUnresolved;
}

std::string door_text(const Door& door) { return fmt::format("door {}", door.id); }

double length_m(const std::string& text, double size_px) {
  return text_width_px(text, size_px) / kPlanPixelsPerMetre;
}

/// Along a wall, within the room, readable from below or from the right.
void write_on_wall(SvgCanvas& canvas, const Rectangle& r, const WallPlace& place, const std::string& text,
                   TextStyle style) {
  const Segment wall = r.wall(place.wall);
  double turn = degrees(std::atan2(wall.direction().y(), wall.direction().x()));
  if (turn > 90.0 + 1e-6) turn -= 180.0;
  if (turn <= -90.0 + 1e-6) turn += 180.0;
  style.turn_deg = turn;
  style.centred = true;
  const Point2 on_wall = wall.from + place.along_m * wall.direction();
  canvas.text(on_wall - place.inside_m * r.normal(place.wall), text, style);
}

/// What the doors of a room take up of its walls, with their names.
std::vector<WallInterval> taken_by_doors(const TopologicalMap& map, const Room& room) {
  std::vector<WallInterval> taken;
  for (const Door& door : map.doors) {
    const DoorFace* face = TopologicalMap::find_face(door, room.id);
    if (!face) continue;
    const double middle = 0.5 * (face->gap.from_m + face->gap.to_m);
    const double half = 0.5 * std::max(face->gap.width_m(), length_m(door_text(door), kDoorText_px));
    taken.push_back({face->gap.wall, middle - half, middle + half});
  }
  return taken;
}

void draw_room(SvgCanvas& canvas, const TopologicalMap& map, const Room& room) {
  const Rectangle r = room.rectangle();
  canvas.text(r.pose().translation(), room.name.empty() ? fmt::format("room {}", room.id) : room.name,
              {.size_px = 15.0, .bold = true});
  canvas.text(r.pose().translation(), fmt::format("{:.1f} m²", r.area_m2()),
              {.size_px = 12.0, .colour = "#607d8b"}, 0.0, 17.0);
  const std::vector<WallInterval> taken = taken_by_doors(map, room);
  for (const int wall : {2, 3}) {
    const std::string text = fmt::format("{:.2f} m", r.wall_length_m(wall));
    write_on_wall(canvas, r, place_dimension(r, wall, taken, length_m(text, kDimension_px)), text,
                  {.size_px = kDimension_px, .colour = "#455a64"});
  }
}

void draw_door(SvgCanvas& canvas, const TopologicalMap& map, const Door& door) {
  const auto draw_face = [&](const DoorFace& face) -> const Room* {
    const Room* room = map.find_room(face.room);
    if (!room) return nullptr;
    const Segment s = segment_in_map(*room, face);
    canvas.line(s.from, s.to, paint_of(door));
    return room;
  };
  const Room* room = draw_face(door.face);
  if (door.other_face) draw_face(*door.other_face);
  if (!room) return;
  const WallInterval& gap = door.face.gap;
  write_on_wall(canvas, room->rectangle(), {gap.wall, 0.5 * (gap.from_m + gap.to_m)}, door_text(door),
                {.size_px = kDoorText_px, .colour = paint_of(door).stroke});
}

}  // namespace

std::string draw_floor_plan(const TopologicalMap& map, const std::string& title) {
  Bounds bounds;
  double area_m2 = 0.0;
  for (const Room& room : map.rooms) {
    bounds.include(room.rectangle());
    area_m2 += room.rectangle().area_m2();
  }
  const std::string contents = fmt::format("{}, {}, {:.1f} m²", counted(map.rooms.size(), "room"),
                                           counted(map.doors.size(), "door"), area_m2);
  if (bounds.empty()) bounds.include(Point2(0.0, 0.0));
  bounds.grow(0.5);
  SvgCanvas canvas(bounds, kPlanPixelsPerMetre);
  for (const Room& room : map.rooms) canvas.rectangle(room.rectangle(), kPlanWall);
  for (const Room& room : map.rooms) draw_room(canvas, map, room);
  for (const Door& door : map.doors) draw_door(canvas, map, door);
  canvas.title(title, contents);
  std::vector<Swatch> legend{{kPassage, "passage"}, {kExit, "exit"}, {kUnresolved, "unresolved"}};
  if (std::ranges::any_of(map.doors, is_shut)) legend.push_back({kShut, "blocked or closed"});
  canvas.legend(legend);
  return canvas.str();
}

}  // namespace enfilade::draw
