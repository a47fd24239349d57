// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "tools/evaluate/exploration/layout.hpp"

namespace enfilade::evaluate {
namespace {

constexpr double kNarrowest_m = 2.2;
constexpr double kLongest_m = 7.5;

/// Cuts the room in two across `axis` at a share of its length.
BuiltRoom cut_off(BuiltRoom& room, int axis, double share, double wall_m) {
  BuiltRoom rest = room;
  const double at_m = room.low[axis] + share * room.size()[axis];
  room.high[axis] = at_m - 0.5 * wall_m;
  rest.low[axis] = at_m + 0.5 * wall_m;
  return rest;
}

bool can_be_cut(const BuiltRoom& room, double wall_m) {
  return room.size().maxCoeff() >= 2.0 * kNarrowest_m + wall_m;
}

void cut_largest(Dice& dice, RandomBuilding& building, std::size_t first) {
  BuiltRoom* largest = nullptr;
  for (std::size_t i = first; i < building.rooms.size(); ++i) {
    BuiltRoom& room = building.rooms[i];
    const bool is_larger = !largest || room.size().prod() > largest->size().prod();
    if (is_larger && can_be_cut(room, building.wall_m)) largest = &room;
  }
  if (!largest) return;
  const Point2 size = largest->size();
  const int axis = size.x() > size.y() ? 0 : 1;
  const double least = (kNarrowest_m + 0.5 * building.wall_m) / size[axis];
  const double share = dice.between(std::max(0.35, least), std::min(0.65, 1.0 - least) + 1e-9);
  building.rooms.push_back(cut_off(*largest, axis, share, building.wall_m));
}

/// A corridor through the middle of the block; the two sides of it are cut further.
void cut_corridor(Dice& dice, RandomBuilding& building) {
  BuiltRoom& block = building.rooms.front();
  const int across = block.size().x() > block.size().y() ? 1 : 0;
  const double whole_m = block.size()[across], corridor_m = dice.between(1.5, 2.3);
  const double begin_m = std::max(kNarrowest_m, dice.between(0.3, 0.5) * whole_m - 0.5 * corridor_m);
  BuiltRoom upper = cut_off(block, across, begin_m / whole_m, building.wall_m);
  const double share = (corridor_m + 0.5 * building.wall_m) / upper.size()[across];
  BuiltRoom corridor = upper;
  const BuiltRoom other = cut_off(corridor, across, share, building.wall_m);
  const BuiltRoom first = block;
  building.rooms = {corridor, first, other};
}

}  // namespace

void lay_out_rooms(const BuildingSpec& spec, Dice& dice, RandomBuilding& building) {
  const auto spread = static_cast<std::size_t>(spec.most_rooms - spec.fewest_rooms + 1);
  const std::size_t count = static_cast<std::size_t>(spec.fewest_rooms) + dice.pick(spread);
  const bool has_corridor = count >= 4 && dice.chance(0.5);
  const double area_m2 = static_cast<double>(count) * dice.between(11.0, 18.0) + (has_corridor ? 8.0 : 0.0);
  const double aspect = has_corridor ? dice.between(0.9, 1.4) : dice.between(0.6, 1.7);
  const Point2 size{std::sqrt(area_m2 * aspect), std::sqrt(area_m2 / aspect)};
  building.rooms = {{Point2::Zero(), size}};
  if (has_corridor) cut_corridor(dice, building);
  const std::size_t first = has_corridor ? 1 : 0;
  while (building.rooms.size() < count) {
    const std::size_t before = building.rooms.size();
    cut_largest(dice, building, first);
    if (building.rooms.size() == before) break;
  }
  // No wall is longer than what the room detector looks for, the corridor's perhaps excepted.
  for (std::size_t i = first; i < building.rooms.size(); ++i)
    if (building.rooms[i].size().maxCoeff() > kLongest_m) cut_largest(dice, building, first);
}

}  // namespace enfilade::evaluate
