// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "tools/draw/figures.hpp"
#include "tools/draw/svg.hpp"

namespace enfilade::draw {
namespace {

constexpr double kPixelsPerMetre = 90.0;

const Paint kWall{.stroke = "#c62828", .width_px = 5.0};
const Paint kOpen{.stroke = "#2e9e3f", .width_px = 7.0};
const Paint kPossible{.stroke = "#9ccc65", .width_px = 7.0};
const Paint kUnexplored{.stroke = "#9e9e9e", .width_px = 5.0, .dash = "4 3"};

const Paint& paint_of(DoorState state) {
  switch (state) {
    case DoorState::kOpen:
      return kOpen;
    case DoorState::kPossible:
      return kPossible;
    case DoorState::kUnexplored:
      return kUnexplored;
  }
  return kUnexplored;
}

Bounds bounds_of(const ScanFigure& figure) {
  Bounds bounds;
  if (figure.estimate.found) {
    bounds.include(figure.estimate.rectangle);
  } else {
    for (const Point2& p : figure.points) bounds.include(p);
  }
  bounds.include(figure.T_zone_base.translation());
  bounds.grow(figure.margin_m);
  return bounds;
}

void draw_walls(SvgCanvas& canvas, const RoomEstimate& estimate) {
  for (std::uint8_t wall = 0; wall < 4; ++wall) {
    double from = 0.0;
    const auto piece = [&](double to, const Paint& paint) {
      const Segment s = segment_of(estimate.rectangle, {wall, from, to});
      if (s.length() > 1e-6) canvas.line(s.from, s.to, paint);
      from = to;
    };
    for (const DoorEstimate& door : estimate.doors) {
      if (door.gap.wall != wall) continue;
      piece(door.gap.from_m, kWall);
      piece(door.gap.to_m, paint_of(door.state));
    }
    piece(estimate.rectangle.wall_length_m(wall), kWall);
  }
}

void draw_robot(SvgCanvas& canvas, const Pose2& T_zone_base) {
  canvas.disc(T_zone_base.translation(), 0.22 * kPixelsPerMetre,
              {.stroke = "#1565c0", .width_px = 1.5, .fill = "#bbdefb"});
  canvas.line(T_zone_base.translation(), T_zone_base * Point2(0.22, 0.0),
              {.stroke = "#1565c0", .width_px = 2.0});
}

/// The points within the bounds, one a pixel.
std::vector<Point2> visible_points(const std::vector<Point2>& points, const Bounds& bounds) {
  std::set<std::pair<int, int>> taken;
  std::vector<Point2> visible;
  for (const Point2& p : points) {
    const bool is_inside = (p.array() > bounds.low.array()).all() && (p.array() < bounds.high.array()).all();
    const Point2 px = kPixelsPerMetre * p;
    if (is_inside && taken.emplace(std::lround(px.x()), std::lround(px.y())).second) visible.push_back(p);
  }
  return visible;
}

}  // namespace

std::string draw_scan(const ScanFigure& figure) {
  const Bounds bounds = bounds_of(figure);
  SvgCanvas canvas(bounds, kPixelsPerMetre);
  draw_robot(canvas, figure.T_zone_base);
  canvas.dots(visible_points(figure.points, bounds), figure.point_px, "#37474f", 0.55);
  std::string size = "no rectangle yet";
  if (figure.estimate.found) {
    draw_walls(canvas, figure.estimate);
    canvas.rectangle(figure.estimate.rectangle, {.stroke = "#000", .width_px = 1.0});
    size = fmt::format("{:.2f} × {:.2f} m", figure.estimate.rectangle.width_m,
                       figure.estimate.rectangle.height_m);
  }
  canvas.title(figure.title, size);
  canvas.legend({{kWall, "wall"}, {kOpen, "door"}, {kPossible, "door?"}, {kUnexplored, "unseen"}});
  return canvas.str();
}

}  // namespace enfilade::draw
