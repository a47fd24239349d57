// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <enfilade_idl/enfilade_requests.h>

#include "interfaces/convert/grid.hpp"
#include "interfaces/convert/room.hpp"
#include "interfaces/model/requests.hpp"

namespace enfilade::wire {

namespace own_srv = ::enfilade_msgs::srv::dds_;

own_srv::FixRoom_Request_ to_wire(const FixRoomRequest& request);
FixRoomRequest from_wire(const own_srv::FixRoom_Request_& request);
own_srv::FixRoom_Response_ to_wire(const FixRoomReply& reply);
FixRoomReply from_wire(const own_srv::FixRoom_Response_& reply);

own_srv::EnterZone_Request_ to_wire(const EnterZoneRequest& request);
EnterZoneRequest from_wire(const own_srv::EnterZone_Request_& request);
own_srv::EnterZone_Response_ to_wire(const EnterZoneReply& reply);
EnterZoneReply from_wire(const own_srv::EnterZone_Response_& reply);

own_srv::MarkDoor_Request_ to_wire(const MarkDoorRequest& request);
MarkDoorRequest from_wire(const own_srv::MarkDoor_Request_& request);
own_srv::MarkDoor_Response_ to_wire(const MarkDoorReply& reply);
MarkDoorReply from_wire(const own_srv::MarkDoor_Response_& reply);

own_srv::Route_Request_ to_wire(const RouteRequest& request);
RouteRequest from_wire(const own_srv::Route_Request_& request);
own_srv::Route_Response_ to_wire(const RouteReply& reply);
RouteReply from_wire(const own_srv::Route_Response_& reply);

own_srv::GridSnapshot_Request_ to_wire(const GridSnapshotRequest& request);
GridSnapshotRequest from_wire(const own_srv::GridSnapshot_Request_& request);
own_srv::GridSnapshot_Response_ to_wire(const GridSnapshotReply& reply);
GridSnapshotReply from_wire(const own_srv::GridSnapshot_Response_& reply);

}  // namespace enfilade::wire
