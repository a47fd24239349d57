// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "tools/simulator/core/shapes.hpp"
#include "tools/simulator/world/readers.hpp"

namespace enfilade::simulator {
namespace {

constexpr double kFar_m = 90.0;
constexpr std::array<const char*, 4> kWalls{"east", "north", "west", "south"};

Pose2 read_pose(YamlFields& fields) {
  return {fields.number_or("x_m", 0.0, -kFar_m, kFar_m), fields.number_or("y_m", 0.0, -kFar_m, kFar_m),
          radians(fields.number_or("yaw_deg", 0.0, -360.0, 360.0))};
}

class FloorPlanReader {
 public:
  FloorPlanReader(YamlFields& top, const std::string& name) : top_(top) { plan_.name = name; }

  FloorPlan read() {
    read_building();
    for (YamlFields& room : top_.list("rooms")) read_room(room);
    for (YamlFields& door : top_.list("doors")) read_door(door);
    for (YamlFields& window : top_.list("windows")) read_window(window);
    for (YamlFields& thing : top_.list("furniture")) read_furniture(thing);
    for (YamlFields& mover : top_.list("moving")) read_moving(mover);
    read_start();
    top_.finish();
    return std::move(plan_);
  }

 private:
  void read_building() {
    plan_.name = top_.text_or("name", plan_.name);
    plan_.wall_thickness_m = top_.number_or("wall_thickness_m", 0.12, 0.02, 1.0);
    ceiling_m_ = top_.number_or("ceiling_m", 2.6, 1.0, 20.0);
    plan_.ground = top_.flag_or("ground", true);
    if (auto building = top_.group("building")) {
      plan_.T_world_building = read_pose(*building);
      building->finish();
    }
  }

  void read_room(YamlFields& fields) {
    PlanRoom room;
    room.line = fields.line();
    room.name = fields.text("name");
    const Pose2 pose = read_pose(fields);
    room.rectangle = {pose.yaw_rad, pose.x_m, pose.y_m, fields.number("width_m", 0.5, 80.0),
                      fields.number("height_m", 0.5, 80.0)};
    room.ceiling_m = fields.number_or("ceiling_m", ceiling_m_, 1.0, 20.0);
    if (find_room(room.name))
      fields.problem_at("name", "a room '" + room.name + "' exists already: choose another name");
    fields.finish();
    plan_.rooms.push_back(room);
  }

  std::optional<std::size_t> find_room(const std::string& name) const {
    const auto found = std::ranges::find(plan_.rooms, name, &PlanRoom::name);
    if (found == plan_.rooms.end()) return std::nullopt;
    return static_cast<std::size_t>(found - plan_.rooms.begin());
  }

  std::optional<std::size_t> room_named(YamlFields& fields, const std::string& key) {
    const std::string name = fields.text(key);
    const auto room = find_room(name);
    if (!room && !name.empty())
      fields.problem_at(key, "there is no room '" + name + "': name one from the list 'rooms'");
    return room;
  }

  /// Room, wall, offset and width. The offset counts from the middle of the wall along the room's own x or y
  /// axis.
  PlanOpening read_opening(YamlFields& fields) {
    PlanOpening opening;
    opening.line = fields.line();
    opening.width_m = fields.number("width_m", 0.1, 20.0);
    const double offset_m = fields.number_or("offset_m", 0.0, -kFar_m, kFar_m);
    const auto room = room_named(fields, "room");
    const std::string wall = fields.text("wall");
    const auto named = std::ranges::find(kWalls, wall);
    if (named == kWalls.end())
      fields.problem_at("wall", "'wall' must be east (+x of the room), north (+y), west or south");
    if (!room || named == kWalls.end()) return opening;
    opening.room = *room;
    opening.wall = static_cast<int>(named - kWalls.begin());
    // The east wall runs north and the north wall runs west: the other way than the room's axis on north and
    // west.
    const double along = opening.wall == 0 || opening.wall == 3 ? 1.0 : -1.0;
    opening.middle_m = 0.5 * plan_.rooms[*room].rectangle.wall_length_m(opening.wall) + along * offset_m;
    return opening;
  }

  void read_door(YamlFields& fields) {
    PlanDoor door;
    door.opening = read_opening(fields);
    door.opening.top_m = fields.number_or("lintel_m", 2.03, 0.2, 20.0);
    if (fields.text("to") != "outside") {
      door.to = room_named(fields, "to");
      if (!door.to) return fields.finish();
    }
    fields.finish();
    if (door.opening.room < plan_.rooms.size()) plan_.doors.push_back(door);
  }

  void read_window(YamlFields& fields) {
    PlanWindow window;
    window.opening = read_opening(fields);
    window.opening.bottom_m = fields.number_or("sill_m", 0.9, 0.0, 20.0);
    window.opening.top_m = fields.number_or("top_m", 2.1, 0.1, 20.0);
    window.glass = fields.flag_or("glass", true);
    if (window.opening.top_m <= window.opening.bottom_m) fields.problem("'top_m' must be above 'sill_m'");
    fields.finish();
    if (window.opening.room < plan_.rooms.size()) plan_.windows.push_back(window);
  }

  /// `room` is optional: with it, coordinates count from the middle of that room along its axes.
  Pose2 T_building_local(YamlFields& fields) {
    if (!fields.has("room")) {
      fields.node("room");
      return {};
    }
    const auto room = room_named(fields, "room");
    return room ? plan_.rooms[*room].rectangle.pose() : Pose2{};
  }

  /// box_m: [along x, along y, height], or cylinder_m: [diameter, height]; `bottom_m` above the floor.
  Solid read_solid(YamlFields& fields, const Pose2& pose) {
    Solid solid;
    solid.bottom_m = fields.number_or("bottom_m", 0.0, 0.0, 20.0);
    if (fields.has("box_m") == fields.has("cylinder_m")) {
      fields.problem("give either box_m: [x, y, height] or cylinder_m: [diameter, height]");
      fields.node("box_m"), fields.node("cylinder_m");
      return solid;
    }
    const bool box = fields.has("box_m");
    fields.node(box ? "cylinder_m" : "box_m");
    const std::vector<double> size = fields.numbers(box ? "box_m" : "cylinder_m", box ? 3 : 2, 0.01, 20.0);
    if (size.empty()) return solid;
    solid.base = box ? outline({pose.yaw_rad, pose.x_m, pose.y_m, size[0], size[1]})
                     : circle_outline(pose.translation(), size[0]);
    solid.top_m = solid.bottom_m + size.back();
    return solid;
  }

  void read_furniture(YamlFields& fields) {
    fields.node("name");
    const Pose2 T = T_building_local(fields);
    const Solid solid = read_solid(fields, T * read_pose(fields));
    fields.finish();
    if (!solid.base.empty()) plan_.furniture.push_back(solid);
  }

  std::vector<Point2> read_waypoints(YamlFields& fields, const Pose2& T_building_room) {
    std::vector<Point2> waypoints;
    for (const YAML::Node& entry : fields.node("waypoints_m")) {
      double x_m = 0.0, y_m = 0.0;
      const bool pair =
          entry.IsSequence() && entry.size() == 2 && YAML::convert<double>::decode(entry[0], x_m) &&
          YAML::convert<double>::decode(entry[1], y_m) && std::isfinite(x_m) && std::isfinite(y_m);
      if (!pair) fields.problem_at("waypoints_m", "a waypoint is a pair [x, y] in metres");
      waypoints.push_back(T_building_room * Point2(x_m, y_m));
    }
    if (waypoints.empty()) fields.problem("'waypoints_m' needs at least one pair [x, y]");
    return waypoints;
  }

  void read_moving(YamlFields& fields) {
    fields.node("name");
    const Pose2 T = T_building_local(fields);
    MovingSolid moving;
    moving.solid =
        read_solid(fields, {0.0, 0.0, T.yaw_rad + radians(fields.number_or("yaw_deg", 0.0, -360.0, 360.0))});
    moving.speed_m_s = fields.number("speed_m_s", 0.0, 10.0);
    moving.waypoints = read_waypoints(fields, T);
    fields.finish();
    if (!moving.solid.base.empty() && !moving.waypoints.empty()) plan_.moving.push_back(moving);
  }

  void read_start() {
    auto start = top_.group("start");
    if (!start)
      return top_.problem(
          "'start' is missing: say where the robot begins, start: {room: NAME, x_m: 0, y_m: 0}");
    const Pose2 T = T_building_local(*start);
    plan_.T_building_start = T * read_pose(*start);
    start->finish();
  }

  YamlFields& top_;
  FloorPlan plan_;
  double ceiling_m_ = 2.6;
};

}  // namespace

FloorPlan read_floor_plan(YamlFields& fields, const std::string& name, YamlProblems& problems) {
  if (!fields.has("rooms"))
    problems.add(
        1,
        "neither 'rooms' (a floor plan) nor 'image' (a map_server map) is here: a world needs one of them");
  return FloorPlanReader(fields, name).read();
}

}  // namespace enfilade::simulator
