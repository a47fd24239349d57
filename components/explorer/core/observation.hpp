// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/explorer/core/projected_grid.hpp"
#include "interfaces/model/exploration.hpp"
#include "interfaces/model/motion.hpp"
#include "interfaces/model/requests.hpp"
#include "interfaces/model/sensing.hpp"

namespace enfilade::explorer {

/// What is known at one moment. Null: not heard of yet. Pointers hold during the call they are passed to.
struct Observation {
  StampNs now_ns = 0;
  std::optional<Pose2> T_zone_base;  ///< the zone's frame is that of the odometry
  StampNs pose_stamp_ns = 0;
  VelocityCommand speed;  ///< as measured
  const MotorState* motor = nullptr;
  const CurrentZone* zone = nullptr;
  const TopologicalMap* map = nullptr;
  const RoomEstimate* estimate = nullptr;
  std::optional<ZoneTag> grid_tag;  ///< of the cells in `grid`, once they are complete
  const ProjectedGrid* grid = nullptr;
  const PointCloud* points = nullptr;  ///< newest line of the sensor, base frame

  const FixRoomReply* fixed = nullptr;  ///< answers that came since the last call
  const EnterZoneReply* entered = nullptr;
  const MarkDoorReply* marked = nullptr;

  bool standing() const {
    return motor && !motor->base_moving && std::abs(speed.linear_m_s) < 0.01 &&
           std::abs(speed.angular_rad_s) < 0.02;
  }
};

/// What shall be done now.
struct Decision {
  bool drives = false;  ///< whether `velocity` is to be sent
  VelocityCommand velocity;
  std::optional<SweepCommand> sweep;
  std::optional<FixRoomRequest> fix_room;
  std::optional<EnterZoneRequest> enter_zone;
  std::optional<MarkDoorRequest> mark_door;
  std::vector<std::string> events;  ///< lines for people
  std::vector<std::string> warnings;

  void drive(const VelocityCommand& v) {
    drives = true;
    velocity = v;
  }
};

}  // namespace enfilade::explorer
