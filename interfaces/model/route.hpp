// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "interfaces/model/topological_map.hpp"

namespace enfilade {

/// One room of a route: straight from `enter` to `leave` (map frame), then through `door`; no door in the
/// last room.
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

  bool operator==(const Route&) const = default;
};

/// Where a route starts or ends.
struct RoutePlace {
  RoomId room = 0;
  Point2 point = Point2::Zero();  ///< map frame

  bool operator==(const RoutePlace&) const = default;
};

}  // namespace enfilade
