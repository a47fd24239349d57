// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>

#include "tools/enfilade/draw/figures.hpp"
#include "tools/enfilade/draw/svg.hpp"

namespace enfilade::draw {
namespace {

constexpr double kPlanPixelsPerMetre = 80.0;
const Paint kPlanWall{.stroke = "#37474f", .width_px = 5.0, .fill = "#fafafa"};
const Paint kPassage{.stroke = "#2e9e3f", .width_px = 7.0};
const Paint kExit{.stroke = "#ef6c00", .width_px = 7.0};
const Paint kUnresolved{.stroke = "#9e9e9e", .width_px = 7.0};

const Paint& paint_of(DoorKind kind) {
  if (kind == DoorKind::kPassage) return kPassage;
  return kind == DoorKind::kExit ? kExit : kUnresolved;
}

/// Text beside wall `i`, outside the room, readable from below or from the right.
void draw_dimension(SvgCanvas& canvas, const Rectangle& r, int i) {
  const Segment wall = r.wall(i);
  double turn = degrees(std::atan2(wall.direction().y(), wall.direction().x()));
  if (turn > 90.0 + 1e-6) turn -= 180.0;
  if (turn <= -90.0 + 1e-6) turn += 180.0;
  canvas.text(wall.midpoint() - 0.16 * r.normal(i), fmt::format("{:.2f} m", wall.length()),
              {.size_px = 12.0, .colour = "#455a64", .turn_deg = turn});
}

void draw_room(SvgCanvas& canvas, const Room& room) {
  const Rectangle r = room.rectangle();
  canvas.text(r.pose().translation(), room.name.empty() ? fmt::format("room {}", room.id) : room.name,
              {.size_px = 15.0, .bold = true});
  canvas.text(r.pose().translation(), fmt::format("{:.1f} m²", r.area_m2()),
              {.size_px = 12.0, .colour = "#607d8b"}, 0.0, 17.0);
  draw_dimension(canvas, r, 2);
  draw_dimension(canvas, r, 3);
}

void draw_door(SvgCanvas& canvas, const TopologicalMap& map, const Door& door) {
  const auto draw_face = [&](const DoorFace& face) -> const Room* {
    const Room* room = map.find_room(face.room);
    if (!room) return nullptr;
    const Segment s = segment_in_map(*room, face);
    canvas.line(s.from, s.to, paint_of(door.kind));
    return room;
  };
  const Room* room = draw_face(door.face);
  if (door.other_face) draw_face(*door.other_face);
  if (!room) return;
  const Segment s = segment_in_map(*room, door.face);
  const Point2 inwards = -0.28 * room->rectangle().normal(door.face.gap.wall);
  canvas.text(s.midpoint() + inwards, fmt::format("door {}", door.id),
              {.size_px = 11.0, .colour = paint_of(door.kind).stroke});
}

}  // namespace

std::string draw_floor_plan(const TopologicalMap& map, const std::string& title) {
  Bounds bounds;
  for (const Room& room : map.rooms) bounds.include(room.rectangle());
  if (bounds.empty()) bounds.include(Point2(0.0, 0.0));
  bounds.grow(0.5);
  SvgCanvas canvas(bounds, kPlanPixelsPerMetre);
  for (const Room& room : map.rooms) canvas.rectangle(room.rectangle(), kPlanWall);
  for (const Room& room : map.rooms) draw_room(canvas, room);
  for (const Door& door : map.doors) draw_door(canvas, map, door);
  canvas.label(12.0, 24.0, title, {.size_px = 15.0, .anchor = "start", .bold = true});
  const double y = canvas.height_px() - 14.0;
  canvas.swatch(12.0, y, kPassage, "passage");
  canvas.swatch(104.0, y, kExit, "exit");
  canvas.swatch(174.0, y, kUnresolved, "unresolved");
  canvas.scale_bar();
  return canvas.str();
}

}  // namespace enfilade::draw
