// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/routes/route.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <unordered_map>

namespace enfilade::topo_graph {
namespace {

/// A door gone through in one direction.
struct Crossing {
  DoorId door;
  RoomId to;
  Point2 near, far;  ///< middles of the faces in the room left and in the room entered
};

using Crossings = std::unordered_map<RoomId, std::vector<std::size_t>>;

struct RouteSearch {
  std::vector<Crossing> crossings;
  Crossings of_room;  ///< those that leave it
};

RouteSearch make_search(const TopologicalMap& map, const std::set<DoorId>& closed) {
  RouteSearch search;
  std::unordered_map<RoomId, const Room*> rooms;
  for (const Room& room : map.rooms) rooms[room.id] = &room;
  const auto add = [&](const Door& door, const DoorFace& near, const DoorFace& far) {
    search.of_room[near.room].push_back(search.crossings.size());
    search.crossings.push_back({door.id, far.room, segment_in_map(*rooms.at(near.room), near).midpoint(),
                                segment_in_map(*rooms.at(far.room), far).midpoint()});
  };
  for (const Door& door : map.doors) {
    if (door.kind != DoorKind::kPassage || !door.other_face) continue;
    if (door.closed || closed.count(door.id)) continue;
    add(door, door.face, *door.other_face);
    add(door, *door.other_face, door.face);
  }
  return search;
}

constexpr std::size_t kStart = std::numeric_limits<std::size_t>::max();

Route trace(const RouteSearch& search, const std::vector<std::size_t>& before, std::size_t last,
            const RoutePlace& from, const RoutePlace& to, double length_m) {
  Route route{.legs = {{.room = to.room, .leave = to.point}}, .length_m = length_m};
  for (std::size_t i = last; i != kStart; i = before[i]) {
    const Crossing& crossing = search.crossings[i];
    route.legs.back().enter = crossing.far;
    const RoomId room = before[i] == kStart ? from.room : search.crossings[before[i]].to;
    route.legs.push_back({.room = room, .leave = crossing.near, .door = crossing.door});
  }
  route.legs.back().enter = from.point;
  std::reverse(route.legs.begin(), route.legs.end());
  return route;
}

}  // namespace

RoutePlace middle_of(const Room& room) { return {room.id, room.T_map_room.translation()}; }

std::optional<RoutePlace> place_at(const TopologicalMap& map, const Point2& point) {
  for (const Room& room : map.rooms)
    if (room.rectangle().contains(point)) return RoutePlace{room.id, point};
  return std::nullopt;
}

/// Dijkstra over the doors, each with its two directions; a crossing is reached at its far side.
std::optional<Route> find_route(const TopologicalMap& map, const RoutePlace& from, const RoutePlace& to,
                                const std::set<DoorId>& closed) {
  RouteSearch search = make_search(map, closed);
  std::vector<double> reached_m(search.crossings.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(search.crossings.size(), kStart);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto leave = [&](RoomId room, const Point2& at, double so_far_m, std::size_t through) {
    for (const std::size_t i : search.of_room[room]) {
      const Crossing& next = search.crossings[i];
      const double length_m = so_far_m + (next.near - at).norm() + (next.far - next.near).norm();
      if (length_m >= reached_m[i]) continue;
      reached_m[i] = length_m;
      before[i] = through;
      open.emplace(length_m, i);
    }
  };
  double best_m = std::numeric_limits<double>::infinity();
  std::size_t last = kStart;
  if (from.room == to.room) best_m = (to.point - from.point).norm();
  leave(from.room, from.point, 0.0, kStart);
  while (!open.empty() && open.top().first < best_m) {
    const auto [length_m, i] = open.top();
    open.pop();
    if (length_m > reached_m[i]) continue;
    const Crossing& crossing = search.crossings[i];
    const double all_m = length_m + (to.point - crossing.far).norm();
    if (crossing.to == to.room && all_m < best_m) best_m = all_m, last = i;
    leave(crossing.to, crossing.far, length_m, i);
  }
  if (best_m == std::numeric_limits<double>::infinity()) return std::nullopt;
  return trace(search, before, last, from, to, best_m);
}

}  // namespace enfilade::topo_graph
