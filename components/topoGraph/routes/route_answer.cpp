// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/routes/route_answer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "components/topoGraph/routes/route.hpp"

namespace enfilade::topo_graph {
namespace {

std::optional<RoutePlace> find_place(const TopologicalMap& map, const RoutePlace& asked) {
  if (asked.room == 0) return place_at(map, asked.point);
  const Room* room = map.find_room(asked.room);
  return room ? std::optional(middle_of(*room)) : std::nullopt;
}

std::string not_found(const RoutePlace& asked) {
  return asked.room == 0
             ? fmt::format("the point {:.3f},{:.3f} lies in no room", asked.point.x(), asked.point.y())
             : fmt::format("there is no room {}", asked.room);
}

std::string no_way(const RoutePlace& from, const RoutePlace& to) {
  return fmt::format("no way leads from room {} to room {} through doors that are open", from.room, to.room);
}

}  // namespace

RouteReply answer_route(const TopologicalMap& map, const RouteRequest& request) {
  RouteReply reply{.call = request.call};
  const auto& closed = request.closed_doors;
  const auto unknown = std::ranges::find_if(closed, [&](DoorId id) { return !map.find_door(id); });
  const auto start = find_place(map, request.start), goal = find_place(map, request.goal);
  if (!start || !goal) {
    reply.message = not_found(start ? request.goal : request.start);
  } else if (unknown != closed.end()) {
    reply.message = fmt::format("there is no door {}", *unknown);
  } else if (auto route = find_route(map, *start, *goal, {closed.begin(), closed.end()})) {
    reply.found = true;
    reply.route = std::move(*route);
  } else {
    reply.message = no_way(*start, *goal);
  }
  return reply;
}

}  // namespace enfilade::topo_graph
