// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "tools/simulator/core/floor_plan.hpp"
#include "tools/simulator/core/shapes.hpp"

namespace enfilade::simulator {
namespace {

constexpr double kGround_m = 200.0;
constexpr double kSlab_m = 0.1;  ///< thickness of floors and ceilings
constexpr double kPane_m = 0.01;
constexpr double kTouch_m = 1e-3;

/// A rectangle of a wall's face: along the wall and upwards.
struct Panel {
  double from_m, to_m, bottom_m, top_m;
};

/// The space an opening takes out of the walls, in the frame of one wall: along it and through it.
struct Cut {
  double from_m, to_m, near_m, far_m;
};

/// Origin at the wall's first corner, x along the wall, y through it from the inner face outwards (so the
/// frame is left-handed).
Cut cut_in_wall_frame(const Segment& wall, const Point2& outward, const std::vector<Point2>& volume) {
  Cut cut{1e9, -1e9, 1e9, -1e9};
  for (const Point2& corner : volume) {
    const double along_m = (corner - wall.from).dot(wall.direction());
    const double through_m = (corner - wall.from).dot(outward);
    cut = {std::min(cut.from_m, along_m), std::max(cut.to_m, along_m), std::min(cut.near_m, through_m),
           std::max(cut.far_m, through_m)};
  }
  return cut;
}

std::vector<Panel> subtract(const std::vector<Panel>& panels, const Panel& hole) {
  std::vector<Panel> rest;
  for (const Panel& p : panels) {
    const double from_m = std::clamp(hole.from_m, p.from_m, p.to_m),
                 to_m = std::clamp(hole.to_m, p.from_m, p.to_m);
    const double bottom_m = std::clamp(hole.bottom_m, p.bottom_m, p.top_m);
    const double top_m = std::clamp(hole.top_m, p.bottom_m, p.top_m);
    if (to_m <= from_m || top_m <= bottom_m) {
      rest.push_back(p);
      continue;
    }
    if (from_m > p.from_m) rest.push_back({p.from_m, from_m, p.bottom_m, p.top_m});
    if (to_m < p.to_m) rest.push_back({to_m, p.to_m, p.bottom_m, p.top_m});
    if (bottom_m > p.bottom_m) rest.push_back({from_m, to_m, p.bottom_m, bottom_m});
    if (top_m < p.top_m) rest.push_back({from_m, to_m, top_m, p.top_m});
  }
  return rest;
}

/// The plan's openings with the ground each one takes out of the walls.
struct Hole {
  PlanOpening opening;
  std::vector<Point2> volume;
};

std::vector<Hole> holes(const FloorPlan& plan) {
  std::vector<Hole> all;
  const auto add = [&](const PlanOpening& opening) {
    const Segment gap = face(plan, opening);
    const Point2 through =
        2.0 * plan.wall_thickness_m * plan.rooms[opening.room].rectangle.normal(opening.wall);
    all.push_back({opening, {gap.from, gap.to, gap.to + through, gap.from + through}});
  };
  for (const PlanDoor& door : plan.doors) add(door.opening);
  for (const PlanWindow& window : plan.windows) add(window.opening);
  return all;
}

bool parallel(const Rectangle& a, const Rectangle& b) {
  return std::abs(wrap_to_quarter(a.yaw_rad - b.yaw_rad)) < 1e-6;
}

std::vector<Solid> wall_slabs(const FloorPlan& plan, const PlanRoom& room, int wall,
                              const std::vector<Hole>& all_holes) {
  const Segment inner = room.rectangle.wall(wall);
  const Point2 along = inner.direction(), outward = room.rectangle.normal(wall);
  const double thick_m = plan.wall_thickness_m;
  std::vector<Panel> panels{{-thick_m, inner.length() + thick_m, 0.0, room.ceiling_m}};
  for (const Hole& hole : all_holes) {
    if (!parallel(room.rectangle, plan.rooms[hole.opening.room].rectangle)) continue;
    const Cut cut = cut_in_wall_frame(inner, outward, hole.volume);
    if (cut.far_m < kTouch_m || cut.near_m > thick_m - kTouch_m) continue;
    panels = subtract(panels, {cut.from_m, cut.to_m, hole.opening.bottom_m, hole.opening.top_m});
  }
  std::vector<Solid> slabs;
  for (const Panel& p : panels) {
    const Point2 a = inner.from + p.from_m * along, b = inner.from + p.to_m * along;
    slabs.push_back({{b, a, a + thick_m * outward, b + thick_m * outward}, p.bottom_m, p.top_m, false});
  }
  return slabs;
}

Solid plate(Rectangle rectangle, double margin_m, double bottom_m, double top_m) {
  rectangle.width_m += 2.0 * margin_m;
  rectangle.height_m += 2.0 * margin_m;
  return {outline(rectangle), bottom_m, top_m, false};
}

Solid pane(const FloorPlan& plan, const PlanOpening& opening) {
  const Segment gap = face(plan, opening);
  const Point2 outward = plan.rooms[opening.room].rectangle.normal(opening.wall);
  const Point2 near = 0.5 * (plan.wall_thickness_m - kPane_m) * outward, far = near + kPane_m * outward;
  return {
      {gap.to + near, gap.from + near, gap.from + far, gap.to + far}, opening.bottom_m, opening.top_m, true};
}

TrueDoor true_door(const FloorPlan& plan, const PlanDoor& door) {
  const PlanOpening& o = door.opening;
  const PlanRoom& room = plan.rooms[o.room];
  const double depth_m = door.to ? facing_wall(plan, door).value().depth_m : plan.wall_thickness_m;
  const Point2 half_way = 0.5 * depth_m * room.rectangle.normal(o.wall);
  const Segment gap = face(plan, o);
  return {.name = room.name + " - " + (door.to ? plan.rooms[*door.to].name : "outside"),
          .opening = plan.T_world_building * Segment{gap.from + half_way, gap.to + half_way},
          .height_m = o.top_m,
          .room = o.room,
          .other = door.to};
}

WorldTruth truth_of(const FloorPlan& plan) {
  WorldTruth truth;
  truth.T_world_start = plan.T_world_building * plan.T_building_start;
  for (const PlanRoom& room : plan.rooms)
    truth.rooms.push_back({room.name, plan.T_world_building * room.rectangle});
  for (const PlanDoor& door : plan.doors) truth.doors.push_back(true_door(plan, door));
  return truth;
}

void add_room(World& world, const FloorPlan& plan, const PlanRoom& room, const std::vector<Hole>& all_holes) {
  for (int wall = 0; wall < 4; ++wall)
    for (Solid& slab : wall_slabs(plan, room, wall, all_holes)) world.solids.push_back(std::move(slab));
  world.solids.push_back(
      plate(room.rectangle, plan.wall_thickness_m, room.ceiling_m, room.ceiling_m + kSlab_m));
  if (!plan.ground) world.solids.push_back(plate(room.rectangle, plan.wall_thickness_m, -kSlab_m, 0.0));
}

}  // namespace

World build_world(const FloorPlan& plan) {
  World world;
  world.name = plan.name;
  const std::vector<Hole> all_holes = holes(plan);
  for (const PlanRoom& room : plan.rooms) add_room(world, plan, room, all_holes);
  for (const PlanWindow& window : plan.windows)
    if (window.glass) world.solids.push_back(pane(plan, window.opening));
  if (plan.ground)
    world.solids.push_back(plate({.width_m = kGround_m, .height_m = kGround_m}, 0.0, -kSlab_m, 0.0));
  world.solids.insert(world.solids.end(), plan.furniture.begin(), plan.furniture.end());
  for (Solid& solid : world.solids)
    for (Point2& corner : solid.base) corner = plan.T_world_building * corner;

  world.moving = plan.moving;
  for (MovingSolid& moving : world.moving) {
    for (Point2& corner : moving.solid.base) corner = rotate(plan.T_world_building.yaw_rad, corner);
    for (Point2& waypoint : moving.waypoints) waypoint = plan.T_world_building * waypoint;
  }
  world.truth = truth_of(plan);
  return world;
}

}  // namespace enfilade::simulator
