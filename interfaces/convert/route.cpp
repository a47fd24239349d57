// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/requests.hpp"

namespace enfilade::wire {

namespace {

own::Point2_ point_to_wire(const Point2& point) {
  own::Point2_ out;
  out.x_m(point.x());
  out.y_m(point.y());
  return out;
}

Point2 point_from_wire(const own::Point2_& point) { return {point.x_m(), point.y_m()}; }

own_srv::RoutePlace_ route_place_to_wire(const RoutePlace& place) {
  own_srv::RoutePlace_ out;
  out.room(place.room);
  out.point(point_to_wire(place.point));
  return out;
}

RoutePlace route_place_from_wire(const own_srv::RoutePlace_& place) {
  return {place.room(), point_from_wire(place.point())};
}

own_srv::RouteLeg_ leg_to_wire(const RouteLeg& leg) {
  own_srv::RouteLeg_ out;
  out.room(leg.room);
  out.enter(point_to_wire(leg.enter));
  out.leave(point_to_wire(leg.leave));
  out.door(leg.door.value_or(0));
  return out;
}

RouteLeg leg_from_wire(const own_srv::RouteLeg_& leg) {
  return {leg.room(), point_from_wire(leg.enter()), point_from_wire(leg.leave()),
          optional_from_wire(leg.door() != 0, leg.door())};
}

}  // namespace

own_srv::Route_Request_ to_wire(const RouteRequest& request) {
  own_srv::Route_Request_ out;
  out.call(to_wire(request.call));
  out.start(route_place_to_wire(request.start));
  out.goal(route_place_to_wire(request.goal));
  out.closed_doors(request.closed_doors);
  return out;
}

RouteRequest from_wire(const own_srv::Route_Request_& request) {
  check_count(request.closed_doors().size(), kMaxDoors, "closed doors");
  return {from_wire(request.call()), route_place_from_wire(request.start()),
          route_place_from_wire(request.goal()), request.closed_doors()};
}

own_srv::Route_Response_ to_wire(const RouteReply& reply) {
  own_srv::Route_Response_ out;
  out.call(to_wire(reply.call));
  out.found(reply.found);
  out.message(reply.message);
  out.legs(each<own_srv::RouteLeg_>(reply.route.legs, leg_to_wire));
  out.length_m(reply.route.length_m);
  return out;
}

RouteReply from_wire(const own_srv::Route_Response_& reply) {
  check_count(reply.legs().size(), kMaxRooms, "rooms on a route");
  return {from_wire(reply.call()), reply.found(), checked(reply.message()),
          Route{each<RouteLeg>(reply.legs(), leg_from_wire), reply.length_m()}};
}

}  // namespace enfilade::wire
