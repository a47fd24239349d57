// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>

#include "interfaces/model/route.hpp"

namespace enfilade::topo_graph {

/// The middle of the room.
RoutePlace middle_of(const Room& room);
/// The room that `point` (map frame) lies in; nothing where it lies in none.
std::optional<RoutePlace> place_at(const TopologicalMap& map, const Point2& point);

/// The shortest way from door to door through passages that are not closed, by the map or by `closed`;
/// straight within each room. Nothing where there is none.
std::optional<Route> find_route(const TopologicalMap& map, const RoutePlace& from, const RoutePlace& to,
                                const std::set<DoorId>& closed = {});

}  // namespace enfilade::topo_graph
