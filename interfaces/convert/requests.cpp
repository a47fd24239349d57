// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/requests.hpp"

namespace enfilade::wire {

own_srv::FixRoom_Request_ to_wire(const FixRoomRequest& request) {
  own_srv::FixRoom_Request_ out;
  out.call(to_wire(request.call));
  out.estimate(to_wire(request.estimate));
  return out;
}

FixRoomRequest from_wire(const own_srv::FixRoom_Request_& request) {
  return {from_wire(request.call()), from_wire(request.estimate())};
}

own_srv::FixRoom_Response_ to_wire(const FixRoomReply& reply) {
  own_srv::FixRoom_Response_ out;
  out.call(to_wire(reply.call));
  out.accepted(reply.accepted);
  out.message(reply.message);
  out.room(reply.room);
  return out;
}

FixRoomReply from_wire(const own_srv::FixRoom_Response_& reply) {
  return {from_wire(reply.call()), reply.accepted(), checked(reply.message()), reply.room()};
}

own_srv::EnterZone_Request_ to_wire(const EnterZoneRequest& request) {
  own_srv::EnterZone_Request_ out;
  out.call(to_wire(request.call));
  out.from_room(request.from_room);
  out.via_door(request.via_door);
  out.pose_zone_base(to_wire(request.T_zone_base));
  out.stamp_ns(request.stamp_ns);
  return out;
}

EnterZoneRequest from_wire(const own_srv::EnterZone_Request_& request) {
  return {from_wire(request.call()), request.from_room(), request.via_door(),
          from_wire(request.pose_zone_base()), request.stamp_ns()};
}

own_srv::EnterZone_Response_ to_wire(const EnterZoneReply& reply) {
  own_srv::EnterZone_Response_ out;
  out.call(to_wire(reply.call));
  out.accepted(reply.accepted);
  out.message(reply.message);
  out.zone_id(reply.zone_id);
  return out;
}

EnterZoneReply from_wire(const own_srv::EnterZone_Response_& reply) {
  return {from_wire(reply.call()), reply.accepted(), checked(reply.message()), reply.zone_id()};
}

own_srv::MarkDoor_Request_ to_wire(const MarkDoorRequest& request) {
  own_srv::MarkDoor_Request_ out;
  out.call(to_wire(request.call));
  out.door(request.door);
  out.kind(enum_to_wire(request.kind));
  out.has_closed(request.closed.has_value());
  out.closed(request.closed.value_or(false));
  return out;
}

MarkDoorRequest from_wire(const own_srv::MarkDoor_Request_& request) {
  return {from_wire(request.call()), request.door(),
          enum_from_wire(request.kind(), DoorKind::kBlocked, "the kind of a door"),
          optional_from_wire(request.has_closed(), request.closed())};
}

own_srv::MarkDoor_Response_ to_wire(const MarkDoorReply& reply) {
  own_srv::MarkDoor_Response_ out;
  out.call(to_wire(reply.call));
  out.accepted(reply.accepted);
  out.message(reply.message);
  return out;
}

MarkDoorReply from_wire(const own_srv::MarkDoor_Response_& reply) {
  return {from_wire(reply.call()), reply.accepted(), checked(reply.message())};
}

own_srv::GridSnapshot_Request_ to_wire(const GridSnapshotRequest& request) {
  own_srv::GridSnapshot_Request_ out;
  out.call(to_wire(request.call));
  return out;
}

GridSnapshotRequest from_wire(const own_srv::GridSnapshot_Request_& request) {
  return {from_wire(request.call())};
}

own_srv::GridSnapshot_Response_ to_wire(const GridSnapshotReply& reply) {
  own_srv::GridSnapshot_Response_ out;
  out.call(to_wire(reply.call));
  out.snapshot(to_wire(reply.snapshot));
  return out;
}

GridSnapshotReply from_wire(const own_srv::GridSnapshot_Response_& reply) {
  return {from_wire(reply.call()), from_wire(reply.snapshot())};
}

}  // namespace enfilade::wire
