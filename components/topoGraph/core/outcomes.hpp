// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "components/topoGraph/core/common_door.hpp"
#include "interfaces/model/requests.hpp"

namespace enfilade::topo_graph {

/// What a request did beside its reply: for the log and for tests. A repeated request does nothing.

struct FixRoomOutcome {
  FixRoomReply reply;
  bool fixed = false;                     ///< whether this call changed the graph
  bool revisited = false;                 ///< the room stood already, and got doors that were missed
  bool covered = false;                   ///< the room was there already, modelled in another zone
  std::optional<CommonDoor> common_door;  ///< how eq. 20 was met
  std::optional<PoseCorrection> correction;
  std::vector<DoorId> new_doors;
  bool minimised = false;         ///< a loop was closed, and eq. 21 minimised
  std::vector<DoorId> withdrawn;  ///< inferred doors that were taken back by it
  std::vector<DoorId>
      joined_doors;  ///< doors of other rooms that turned out to lead here, the common door included
};

struct EnterZoneOutcome {
  EnterZoneReply reply;
  bool entered = false;
  bool joined_by_position = false;  ///< the door became a passage because the robot stands in a stored room
};

struct MarkDoorOutcome {
  MarkDoorReply reply;
  bool marked = false;
};

struct ObserveOutcome {
  std::optional<PoseCorrection> correction;
  bool odometry_restarted = false;  ///< the zone frame is a new one
  bool room_found_again = false;    ///< and the room was found in it
  bool room_withdrawn = false;      ///< this is not the room that the graph took it for
  bool minimised = false;           ///< an inferred door was confirmed, and eq. 21 minimised
};

}  // namespace enfilade::topo_graph
