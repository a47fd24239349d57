// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "tools/evaluate/exploration/layout.hpp"

namespace enfilade::evaluate {
namespace {

constexpr double kCell_m = 0.1;
constexpr double kClearance_m = 0.38;  // of the robot's middle, for it to pass
constexpr double kInFront_m = 0.6;     // of a door, where the robot stands before it goes through

double distance_to(const BuiltThing& thing, const Point2& p) {
  const Point2 q = rotate(-thing.yaw_rad, p - thing.place);
  if (thing.is_round) return q.norm() - 0.5 * thing.size.x();
  const Point2 outside = (q.cwiseAbs() - 0.5 * thing.size).cwiseMax(0.0);
  return outside.norm();
}

/// Where one stands inside `room` before a door; nothing where the door is none of its own.
std::optional<Point2> before_door(const RandomBuilding& building, const BuiltDoor& door, std::size_t room) {
  const int axis = door.opening.wall % 2;
  const bool is_far_side = door.to && *door.to == room;
  if (door.opening.room != room && !is_far_side) return std::nullopt;
  const int wall = is_far_side ? (door.opening.wall + 2) % 4 : door.opening.wall;
  const BuiltRoom& r = building.rooms[room];
  Point2 p;
  p[1 - axis] = door.opening.middle_m;
  p[axis] = wall < 2 ? r.high[axis] - kInFront_m : r.low[axis] + kInFront_m;
  return p;
}

std::vector<Point2> places_to_reach(const RandomBuilding& building, std::size_t room) {
  std::vector<Point2> places;
  for (const BuiltDoor& door : building.doors)
    if (const auto place = before_door(building, door, room)) places.push_back(*place);
  if (building.start_room == room) places.push_back(building.T_building_start.translation());
  return places;
}

/// The floor of a room on which the robot's middle can be.
class FreeFloor {
 public:
  FreeFloor(const RandomBuilding& building, std::size_t room) : room_(building.rooms[room]) {
    nx_ = static_cast<int>(room_.size().x() / kCell_m);
    ny_ = static_cast<int>(room_.size().y() / kCell_m);
    free_.assign(static_cast<std::size_t>(nx_ * ny_), true);
    for (int i = 0; i < nx_ * ny_; ++i) {
      const Point2 p = centre(i);
      const double to_wall_m = std::min((p - room_.low).minCoeff(), (room_.high - p).minCoeff());
      bool is_free = to_wall_m >= kClearance_m;
      for (const BuiltThing& thing : building.furniture)
        is_free = is_free && (thing.room != room || distance_to(thing, p) >= kClearance_m);
      free_[static_cast<std::size_t>(i)] = is_free;
    }
  }

  /// Whether all of `places` are free and joined.
  bool joins(const std::vector<Point2>& places) const {
    if (places.empty()) return true;
    std::vector<bool> reached(free_.size(), false);
    std::vector<int> open{index(places.front())};
    while (!open.empty()) {
      const int i = open.back();
      open.pop_back();
      const auto at = static_cast<std::size_t>(i);
      if (i < 0 || reached[at] || !free_[at]) continue;
      reached[at] = true;
      const int x = i % nx_;
      if (x > 0) open.push_back(i - 1);
      if (x + 1 < nx_) open.push_back(i + 1);
      if (i >= nx_) open.push_back(i - nx_);
      if (i + nx_ < nx_ * ny_) open.push_back(i + nx_);
    }
    return std::all_of(places.begin(), places.end(), [&](const Point2& p) {
      return index(p) >= 0 && reached[static_cast<std::size_t>(index(p))];
    });
  }

 private:
  Point2 centre(int i) const { return room_.low + kCell_m * Point2(i % nx_ + 0.5, i / nx_ + 0.5); }
  int index(const Point2& p) const {
    const int x = static_cast<int>((p.x() - room_.low.x()) / kCell_m),
              y = static_cast<int>((p.y() - room_.low.y()) / kCell_m);
    return x < 0 || y < 0 || x >= nx_ || y >= ny_ ? -1 : y * nx_ + x;
  }

  BuiltRoom room_;
  int nx_ = 0, ny_ = 0;
  std::vector<bool> free_;
};

BuiltThing any_thing(Dice& dice, std::size_t room) {
  BuiltThing thing{.room = room, .is_round = dice.chance(0.25)};
  if (thing.is_round) {
    const double diameter_m = dice.between(0.2, 0.9);
    thing.size = {diameter_m, diameter_m};
    thing.height_m = dice.between(0.3, 1.6);
    return thing;
  }
  const bool is_tall = dice.chance(0.35);
  thing.size = {dice.between(0.4, is_tall ? 1.4 : 2.0), dice.between(0.3, is_tall ? 0.6 : 0.9)};
  thing.height_m = is_tall ? dice.between(1.4, 2.0) : dice.between(0.35, 1.1);
  return thing;
}

/// Against a wall, its back nearly square to it, or anywhere.
void put(Dice& dice, const BuiltRoom& room, BuiltThing& thing) {
  const bool at_wall = dice.chance(0.7);
  const std::size_t wall = dice.pick(4);
  const int axis = static_cast<int>(wall % 2);
  const double slant_rad = dice.chance(0.3) ? radians(dice.between(-6.0, 6.0)) : 0.0;
  thing.yaw_rad = at_wall ? slant_rad + (axis == 0 ? 0.5 * kPi : 0.0) : dice.between(-kPi, kPi);
  const double depth_m = 0.5 * (thing.is_round ? thing.size.x() : thing.size.y());
  const double reach_m = 0.5 * thing.size.norm();
  for (int a = 0; a < 2; ++a)
    thing.place[a] =
        dice.between(room.low[a] + reach_m, std::max(room.high[a] - reach_m, room.low[a] + reach_m + 1e-3));
  if (!at_wall) return;
  const double off_m =
      depth_m + dice.between(0.0, 0.06) + std::abs(std::sin(slant_rad)) * 0.5 * thing.size.x();
  thing.place[axis] = wall < 2 ? room.high[axis] - off_m : room.low[axis] + off_m;
}

bool fits(const RandomBuilding& building, const BuiltThing& thing) {
  const BuiltRoom& room = building.rooms[thing.room];
  for (const double sx : {-0.5, 0.5}) {
    for (const double sy : {-0.5, 0.5}) {
      const Point2 corner = thing.place + rotate(thing.yaw_rad, {sx * thing.size.x(), sy * thing.size.y()});
      const Point2 margin = (corner - room.low).cwiseMin(room.high - corner);
      if (!thing.is_round && margin.minCoeff() < 0.0) return false;
    }
  }
  const double reach_m = 0.5 * thing.size.norm();
  return std::none_of(building.furniture.begin(), building.furniture.end(), [&](const BuiltThing& other) {
    return other.room == thing.room && distance_to(other, thing.place) < 0.6 * reach_m;
  });
}

void furnish_room(Dice& dice, std::size_t room, RandomBuilding& building) {
  const double area_m2 = building.rooms[room].size().prod();
  const std::vector<Point2> places = places_to_reach(building, room);
  const int wanted = static_cast<int>(area_m2 * dice.between(0.1, 0.45));
  for (int i = 0; i < wanted; ++i) {
    BuiltThing thing = any_thing(dice, room);
    put(dice, building.rooms[room], thing);
    if (!fits(building, thing)) continue;
    building.furniture.push_back(thing);
    if (!FreeFloor(building, room).joins(places)) building.furniture.pop_back();
  }
}

void place_start(Dice& dice, RandomBuilding& building) {
  building.start_room = dice.pick(building.rooms.size());
  const BuiltRoom& room = building.rooms[building.start_room];
  constexpr double kOffWalls_m = 0.55;
  building.T_building_start = {dice.between(room.low.x() + kOffWalls_m, room.high.x() - kOffWalls_m),
                               dice.between(room.low.y() + kOffWalls_m, room.high.y() - kOffWalls_m),
                               dice.between(-kPi, kPi)};
}

/// Whether all rooms stay joined without these doors.
bool can_be_spared(const RandomBuilding& building, const std::vector<bool>& without) {
  std::vector<bool> reached(building.rooms.size(), false);
  reached[building.start_room] = true;
  for (std::size_t round = 0; round < building.rooms.size(); ++round) {
    for (std::size_t i = 0; i < building.doors.size(); ++i) {
      const BuiltDoor& d = building.doors[i];
      if (without[i] || !d.to || reached[d.opening.room] == reached[*d.to]) continue;
      reached[d.opening.room] = reached[*d.to] = true;
    }
  }
  return std::all_of(reached.begin(), reached.end(), [](bool r) { return r; });
}

void block_doors(const BuildingSpec& spec, Dice& dice, RandomBuilding& building) {
  std::vector<bool> blocked(building.doors.size(), false);
  for (std::size_t i = 0; i < building.doors.size(); ++i) {
    std::vector<bool> without = blocked;
    without[i] = true;
    if (!dice.chance(spec.blocked_doors) || !can_be_spared(building, without)) continue;
    const BuiltOpening& o = building.doors[i].opening;
    const auto place = before_door(building, building.doors[i], o.room);
    const BuiltThing thing{
        .room = o.room, .place = *place, .size = {o.width_m, o.width_m}, .height_m = dice.between(0.4, 1.2)};
    const double to_start_m = distance_to(thing, building.T_building_start.translation());
    if (to_start_m <= kClearance_m) continue;
    building.furniture.push_back(thing);
    blocked[i] = true;
  }
}

void add_walkers(const BuildingSpec& spec, Dice& dice, RandomBuilding& building) {
  for (std::size_t i = 0; i < building.rooms.size(); ++i) {
    if (!dice.chance(spec.walkers)) continue;
    const BuiltRoom& room = building.rooms[i];
    const Point2 half = (0.5 * room.size()).array() - 0.5;
    const Point2 aside = half.cwiseProduct(Point2(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0)));
    const Point2 begin = room.middle() + aside;
    if ((begin - building.T_building_start.translation()).norm() < 2.0 * kClearance_m) continue;
    building.walkers.push_back({i, {begin, Point2(room.middle() - aside)}, dice.between(0.3, 0.9)});
  }
}

}  // namespace

void furnish(const BuildingSpec& spec, Dice& dice, RandomBuilding& building) {
  place_start(dice, building);
  for (std::size_t room = 0; room < building.rooms.size(); ++room) furnish_room(dice, room, building);
  block_doors(spec, dice, building);
  add_walkers(spec, dice, building);
}

}  // namespace enfilade::evaluate
