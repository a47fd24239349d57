// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/floor_plan.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::simulator {
namespace {

constexpr double kTolerance_m = 1e-6;

std::string quoted(const std::string& name) { return "'" + name + "'"; }

Rectangle grown(Rectangle rectangle, double margin_m) {
  rectangle.width_m += 2.0 * margin_m;
  rectangle.height_m += 2.0 * margin_m;
  return rectangle;
}

std::optional<std::string> opening_problem(const FloorPlan& plan, const PlanOpening& opening) {
  const PlanRoom& room = plan.rooms[opening.room];
  const double from_m = opening.middle_m - 0.5 * opening.width_m,
               to_m = opening.middle_m + 0.5 * opening.width_m;
  if (from_m < -kTolerance_m || to_m > room.rectangle.wall_length_m(opening.wall) + kTolerance_m)
    return "the opening reaches beyond the end of this wall of " + quoted(room.name) + ": move or narrow it";
  if (opening.top_m > room.ceiling_m + kTolerance_m)
    return "the opening is higher than the ceiling of " + quoted(room.name) + ": lower it";
  return std::nullopt;
}

std::optional<std::string> door_problem(const FloorPlan& plan, const PlanDoor& door) {
  const std::string from = quoted(plan.rooms[door.opening.room].name);
  if (door.to) {
    if (facing_wall(plan, door)) return std::nullopt;
    return "no wall of " + quoted(plan.rooms[*door.to].name) + " lies right behind this door of " + from +
           ": rooms joined by a door stand parallel, one or two wall thicknesses apart";
  }
  const PlanRoom& room = plan.rooms[door.opening.room];
  const Point2 beyond = face(plan, door.opening).midpoint() +
                        (plan.wall_thickness_m + 0.3) * room.rectangle.normal(door.opening.wall);
  for (const PlanRoom& other : plan.rooms)
    if (other.rectangle.contains(beyond))
      return "this door leads into " + quoted(other.name) + ": write to: " + other.name;
  return std::nullopt;
}

std::optional<std::string> room_problem(const FloorPlan& plan, std::size_t index) {
  const Rectangle walls = grown(plan.rooms[index].rectangle, plan.wall_thickness_m - kTolerance_m);
  for (std::size_t i = 0; i < index; ++i)
    if (iou(walls, plan.rooms[i].rectangle) > 1e-7)
      return "a wall of " + quoted(plan.rooms[index].name) + " stands inside " + quoted(plan.rooms[i].name) +
             ": keep rooms at least one wall thickness apart";
  return std::nullopt;
}

}  // namespace

Segment face(const FloorPlan& plan, const PlanOpening& opening) {
  const WallInterval gap{static_cast<std::uint8_t>(opening.wall), opening.middle_m - 0.5 * opening.width_m,
                         opening.middle_m + 0.5 * opening.width_m};
  return segment_of(plan.rooms[opening.room].rectangle, gap);
}

std::optional<FacingWall> facing_wall(const FloorPlan& plan, const PlanDoor& door) {
  const Rectangle& here = plan.rooms[door.opening.room].rectangle;
  const Rectangle& there = plan.rooms[*door.to].rectangle;
  const Point2 outward = here.normal(door.opening.wall);
  const Segment gap = face(plan, door.opening);
  for (int wall = 0; wall < 4; ++wall) {
    if ((there.normal(wall) + outward).norm() > kTolerance_m) continue;
    const Segment behind = there.wall(wall);
    const double depth_m = (behind.from - gap.from).dot(outward);
    // The far wall runs the other way, so the gap's end is its beginning there.
    const double from_m = (gap.to - behind.from).dot(behind.direction());
    const double to_m = (gap.from - behind.from).dot(behind.direction());
    const bool fits = from_m > -kTolerance_m && to_m < behind.length() + kTolerance_m;
    if (!fits || depth_m < 0.0 || depth_m > 2.0 * plan.wall_thickness_m + kTolerance_m) return std::nullopt;
    return FacingWall{{static_cast<std::uint8_t>(wall), from_m, to_m}, depth_m};
  }
  return std::nullopt;
}

std::vector<PlanProblem> problems(const FloorPlan& plan) {
  std::vector<PlanProblem> found;
  const auto add = [&found](int line, const std::optional<std::string>& what) {
    if (what) found.push_back({line, *what});
  };
  if (plan.rooms.empty()) add(1, "a world needs at least one room: add it under 'rooms'");
  for (std::size_t i = 0; i < plan.rooms.size(); ++i) add(plan.rooms[i].line, room_problem(plan, i));
  for (const PlanDoor& door : plan.doors) {
    add(door.opening.line, opening_problem(plan, door.opening));
    add(door.opening.line, door_problem(plan, door));
  }
  for (const PlanWindow& window : plan.windows)
    add(window.opening.line, opening_problem(plan, window.opening));
  return found;
}

}  // namespace enfilade::simulator
