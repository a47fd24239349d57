// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numeric>

#include "tools/evaluate/exploration/layout.hpp"

namespace enfilade::evaluate {
namespace {

constexpr double kTouch_m = 1e-6;

/// Where two rooms share a wall: `wall` of the first one, and the stretch along it.
struct Party {
  std::size_t a = 0, b = 0;
  int wall = 0;
  double from_m = 0.0, to_m = 0.0;
};

std::vector<Party> party_walls(const RandomBuilding& building) {
  std::vector<Party> found;
  for (std::size_t a = 0; a < building.rooms.size(); ++a) {
    for (std::size_t b = 0; b < building.rooms.size(); ++b) {
      const BuiltRoom &here = building.rooms[a], &there = building.rooms[b];
      for (int axis = 0; axis < 2; ++axis) {
        if (std::abs(there.low[axis] - here.high[axis] - building.wall_m) > kTouch_m) continue;
        const double from_m = std::max(here.low[1 - axis], there.low[1 - axis]);
        const double to_m = std::min(here.high[1 - axis], there.high[1 - axis]);
        if (to_m - from_m > 1.0) found.push_back({a, b, axis, from_m, to_m});
      }
    }
  }
  return found;
}

/// The stretches of the room's walls behind which no room lies.
std::vector<Party> outer_walls(const RandomBuilding& building) {
  std::vector<Party> found;
  Point2 low = building.rooms.front().low, high = building.rooms.front().high;
  for (const BuiltRoom& room : building.rooms) {
    low = low.cwiseMin(room.low);
    high = high.cwiseMax(room.high);
  }
  for (std::size_t i = 0; i < building.rooms.size(); ++i) {
    const BuiltRoom& room = building.rooms[i];
    for (int wall = 0; wall < 4; ++wall) {
      const int axis = wall % 2;
      const bool is_outer =
          wall < 2 ? high[axis] - room.high[axis] < kTouch_m : room.low[axis] - low[axis] < kTouch_m;
      if (is_outer) found.push_back({i, i, wall, room.low[1 - axis], room.high[1 - axis]});
    }
  }
  return found;
}

/// Most doors keep off the corners, some stand right in one.
BuiltOpening opening_in(Dice& dice, const Party& party, double width_m) {
  const double spare_m = party.to_m - party.from_m - width_m;
  const double margin_m = std::min(0.5 * spare_m, dice.chance(0.2) ? 0.03 : 0.25);
  const double at_m = dice.chance(0.15) ? margin_m : dice.between(margin_m, spare_m - margin_m + kTouch_m);
  return {party.a, party.wall, party.from_m + at_m + 0.5 * width_m, width_m};
}

double door_width_m(Dice& dice, const Party& party) {
  return std::min(dice.between(0.75, 1.2), party.to_m - party.from_m - 0.1);
}

void add_door(Dice& dice, RandomBuilding& building, const Party& party, std::optional<std::size_t> to) {
  BuiltDoor door{.opening = opening_in(dice, party, door_width_m(dice, party)), .to = to};
  door.lintel_m = std::min(building.ceiling_m - 0.2, dice.between(1.98, 2.15));
  building.doors.push_back(door);
}

/// Whether rooms are joined already; `group` is a disjoint-set forest.
std::size_t root_of(std::vector<std::size_t>& group, std::size_t i) {
  while (group[i] != i) i = group[i] = group[group[i]];
  return i;
}

bool overlaps_door(const RandomBuilding& building, const BuiltOpening& o) {
  return std::any_of(building.doors.begin(), building.doors.end(), [&](const BuiltDoor& door) {
    const BuiltOpening& d = door.opening;
    return d.room == o.room && d.wall == o.wall &&
           std::abs(d.middle_m - o.middle_m) < 0.5 * (d.width_m + o.width_m) + 0.2;
  });
}

void add_windows(Dice& dice, RandomBuilding& building) {
  for (const Party& wall : outer_walls(building)) {
    if (!dice.chance(0.35)) continue;
    const double width_m = std::min(dice.between(0.8, 1.8), wall.to_m - wall.from_m - 0.4);
    const BuiltOpening opening = opening_in(dice, wall, width_m);
    if (!overlaps_door(building, opening))
      building.windows.push_back({opening, dice.between(0.7, 1.1), dice.chance(0.8)});
  }
}

}  // namespace

void lay_out_openings(const BuildingSpec&, Dice& dice, RandomBuilding& building) {
  std::vector<Party> walls = party_walls(building);
  for (std::size_t i = walls.size(); i > 1; --i) std::swap(walls[i - 1], walls[dice.pick(i)]);
  std::vector<std::size_t> group(building.rooms.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::vector<Party> spare;
  for (const Party& wall : walls) {
    const std::size_t a = root_of(group, wall.a), b = root_of(group, wall.b);
    if (a == b) {
      spare.push_back(wall);
      continue;
    }
    group[a] = b;
    add_door(dice, building, wall, wall.b);
  }
  for (const Party& wall : spare)
    if (dice.chance(0.3)) add_door(dice, building, wall, wall.b);
  const std::vector<Party> outside = outer_walls(building);
  const std::size_t exits = dice.pick(3);
  for (std::size_t i = 0; i < exits; ++i)
    add_door(dice, building, outside[dice.pick(outside.size())], std::nullopt);
  // Two exits in one wall may have met.
  for (std::size_t i = 0; i < building.doors.size();) {
    const BuiltDoor door = building.doors[i];
    building.doors.erase(building.doors.begin() + static_cast<std::ptrdiff_t>(i));
    if (!door.to && overlaps_door(building, door.opening)) continue;
    building.doors.insert(building.doors.begin() + static_cast<std::ptrdiff_t>(i), door);
    ++i;
  }
  add_windows(dice, building);
}

}  // namespace enfilade::evaluate
