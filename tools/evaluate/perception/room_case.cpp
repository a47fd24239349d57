// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/perception/room_case.hpp"

#include <algorithm>
#include <cmath>

#include "tools/simulator/core/random.hpp"
#include "tools/simulator/core/shapes.hpp"

namespace enfilade::evaluate {
namespace {

using simulator::FloorPlan;
using simulator::PlanDoor;
using simulator::PlanRoom;
using simulator::Random;

constexpr double kLowWall_m = 1.2;
constexpr double kLintel_m = 2.03;
constexpr double kRobotClearance_m = 0.6;
constexpr double kDoorClearance_m = 0.8;

class Architect {
 public:
  Architect(std::uint64_t seed, Hardship hardship) : random_(seed), hardship_(hardship) {}

  FloorPlan draw() {
    plan_ = {};
    plan_.T_world_building = {uniform(-2, 2), uniform(-2, 2), uniform(-kPi, kPi)};
    ceiling_m_ = hardship_ == Hardship::kLowWalls ? kLowWall_m : uniform(2.45, 2.9);
    add_room("room", {0.0, 0.0, 0.0, uniform(2.6, 6.8), uniform(2.6, 6.8)});
    const int side = integer(0, 3);
    add_neighbour(side);
    add_corridor((side + 2) % 4);
    if (random_.happens(0.25)) add_door((side + 3) % 4, {0.0, wall_length(side + 3)}, std::nullopt);
    add_window((side + 1) % 4);
    place_robot();
    add_furniture();
    if (hardship_ == Hardship::kPeople) add_people();
    return plan_;
  }
  Point2 neighbour_place() const { return {plan_.rooms[1].rectangle.x_m, plan_.rooms[1].rectangle.y_m}; }
  double any_yaw() { return uniform(-kPi, kPi); }

 private:
  double uniform(double a, double b) { return a + (b - a) * random_.uniform(); }
  int integer(int a, int b) { return a + static_cast<int>(random_.uniform() * (b - a + 1)); }
  const Rectangle& room() const { return plan_.rooms[0].rectangle; }
  double wall_length(int wall) const { return room().wall_length_m(wall % 4); }

  void add_room(const char* name, const Rectangle& r) { plan_.rooms.push_back({name, r, ceiling_m_, 0}); }

  /// A room behind `wall`, `depth_m` deep, covering from … to of the wall and what lies beyond its ends.
  void add_behind(const char* name, int wall, double depth_m, double from_m, double to_m) {
    const Segment face = room().wall(wall);
    const Point2 centre = face.from + 0.5 * (from_m + to_m) * face.direction() +
                          (plan_.wall_thickness_m + 0.5 * depth_m) * room().normal(wall);
    const double along = to_m - from_m;
    add_room(name,
             {0.0, centre.x(), centre.y(), wall % 2 == 0 ? depth_m : along, wall % 2 == 0 ? along : depth_m});
    add_door(wall, {std::max(0.0, from_m), std::min(wall_length(wall), to_m)}, plan_.rooms.size() - 1);
  }

  void add_neighbour(int wall) {
    const double length = wall_length(wall), depth = uniform(2.5, 6.0);
    if (hardship_ == Hardship::kCollinear) return add_behind("neighbour", wall, depth, 0.0, length);
    const double from = uniform(-2.0, length - 1.4);
    add_behind("neighbour", wall, depth, from, std::max(from + 2.5, uniform(1.4, length + 2.0)));
  }

  void add_corridor(int wall) {
    add_behind("corridor", wall, uniform(1.4, 2.2), uniform(-5.0, 0.0),
               wall_length(wall) + uniform(0.0, 5.0));
  }

  struct Stretch {
    double from_m, to_m;
  };
  void add_door(int wall, const Stretch& where, std::optional<std::size_t> to) {
    const double width = uniform(0.75, 1.0), margin = 0.5 * width + 0.08;
    if (where.to_m - where.from_m < 2.0 * margin) return;
    const double top = std::min(kLintel_m, ceiling_m_);
    const double middle = uniform(where.from_m + margin, where.to_m - margin);
    plan_.doors.push_back({{0, wall, middle, width, 0.0, top, 0}, to});
    thresholds_.push_back(simulator::face(plan_, plan_.doors.back().opening).midpoint());
  }

  void add_window(int wall) {
    const bool is_glass_wall = hardship_ == Hardship::kGlass;
    if (hardship_ == Hardship::kLowWalls || (!is_glass_wall && !random_.happens(0.6))) return;
    const double width = uniform(0.8, std::min(2.0, wall_length(wall) - 0.6));
    const double middle = uniform(0.5 * width + 0.2, wall_length(wall) - 0.5 * width - 0.2);
    plan_.windows.push_back(
        {{0, wall, middle, width, is_glass_wall ? 0.0 : 0.9, is_glass_wall ? 2.1 : 2.0, 0}, true});
  }

  void place_robot() {
    const double x = 0.5 * room().width_m - kRobotClearance_m, y = 0.5 * room().height_m - kRobotClearance_m;
    plan_.T_building_start = {uniform(-x, x), uniform(-y, y), any_yaw()};
  }

  void add_furniture() {
    for (int i = integer(6, 10); i > 0; --i)
      add_piece(uniform(0.4, 2.0), uniform(0.3, 1.5), uniform(0.3, 0.7));
    if (hardship_ != Hardship::kCupboards) return;
    for (int i = integer(2, 4); i > 0; --i)
      add_piece(ceiling_m_ - uniform(0.0, 0.15), uniform(0.8, 2.0), 0.6, true);
  }

  /// Three in four pieces stand against a wall.
  void add_piece(double top_m, double long_m, double deep_m, bool at_wall = false) {
    top_m = std::min(top_m, ceiling_m_ - 0.1);
    const bool turned = random_.happens(0.5);
    const double sx = turned ? deep_m : long_m, sy = turned ? long_m : deep_m;
    Point2 low{uniform(-0.5 * room().width_m, 0.5 * room().width_m - sx),
               uniform(-0.5 * room().height_m, 0.5 * room().height_m - sy)};
    if (at_wall || random_.happens(0.75)) {
      const int axis = turned ? 0 : 1;
      const double half = 0.5 * (axis == 0 ? room().width_m : room().height_m);
      low[axis] = random_.happens(0.5) ? -half : half - deep_m;
    }
    const Rectangle base{0.0, low.x() + 0.5 * sx, low.y() + 0.5 * sy, sx, sy};
    const auto blocks = [&](const Point2& p, double margin) { return base.contains(p, -margin); };
    if (blocks(plan_.T_building_start.translation(), kRobotClearance_m)) return;
    if (std::any_of(thresholds_.begin(), thresholds_.end(),
                    [&](const Point2& p) { return blocks(p, kDoorClearance_m); }))
      return;
    plan_.furniture.push_back({simulator::outline(base), 0.0, top_m, false});
  }

  void add_people() {
    for (int i = 0; i < 2; ++i) {
      const double x = 0.5 * room().width_m - 0.4, y = 0.5 * room().height_m - 0.4;
      plan_.moving.push_back(
          {{simulator::circle_outline(Point2::Zero(), 0.45), 0.0, uniform(1.6, 1.85), false},
           {{uniform(-x, x), uniform(-y, y)}, {uniform(-x, x), uniform(-y, y)}},
           uniform(0.4, 1.0)});
    }
  }

  Random random_;
  Hardship hardship_;
  FloorPlan plan_;
  double ceiling_m_ = 2.6;
  std::vector<Point2> thresholds_;
};

/// An arena has walls and nothing above them.
void take_off_ceilings(simulator::World& world) {
  std::erase_if(world.solids, [](const simulator::Solid& s) { return s.bottom_m >= kLowWall_m - 1e-6; });
}

}  // namespace

RoomCase make_room_case(std::uint64_t seed, Hardship hardship) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    Architect architect(1000 * seed + attempt, hardship);
    const FloorPlan plan = architect.draw();
    if (!simulator::problems(plan).empty()) continue;
    RoomCase out;
    out.world = simulator::build_world(plan);
    if (hardship == Hardship::kLowWalls) take_off_ceilings(out.world);
    out.room = out.world.truth.rooms.front().rectangle;
    out.doors = out.world.truth.doors;
    out.T_world_base = out.world.truth.T_world_start;
    const Point2 next_door = plan.T_world_building * architect.neighbour_place();
    out.T_world_neighbour = {next_door.x(), next_door.y(), architect.any_yaw()};
    return out;
  }
}

}  // namespace enfilade::evaluate
