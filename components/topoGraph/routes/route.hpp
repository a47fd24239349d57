// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "interfaces/model/topological_map.hpp"

namespace enfilade::topo_graph {

/// One room of a route: straight from `enter` to `leave`, then through `door`; no door in the last room.
struct RouteLeg {
  RoomId room = 0;
  Point2 enter = Point2::Zero();
  Point2 leave = Point2::Zero();
  std::optional<DoorId> door;

  bool operator==(const RouteLeg&) const = default;
};

struct Route {
  std::vector<RouteLeg> legs;
  double length_m = 0.0;  ///< including the way through the walls
};

/// Where a route starts or ends.
struct RoutePlace {
  RoomId room = 0;
  Point2 point = Point2::Zero();  ///< map frame
};

/// The middle of the room.
RoutePlace middle_of(const Room& room);
/// The room that `point` (map frame) lies in; nothing where it lies in none.
std::optional<RoutePlace> place_at(const TopologicalMap& map, const Point2& point);

/// The shortest way from door to door through passages that are not `closed`, straight within each room.
/// Nothing where there is none.
std::optional<Route> find_route(const TopologicalMap& map, const RoutePlace& from, const RoutePlace& to,
                                const std::set<DoorId>& closed = {});

}  // namespace enfilade::topo_graph
