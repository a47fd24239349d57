// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "interfaces/geometry/pose2.hpp"
#include "interfaces/model/zone_tag.hpp"

namespace enfilade {

/// rt/clock.
struct ClockTick {
  StampNs now_ns = 0;

  bool operator==(const ClockTick&) const = default;
};

/// A component has handled all that it was sent up to this simulated time; the simulator goes no further
/// ahead than its window.
struct SimCredit {
  std::string component_name;
  StampNs done_ns = 0;

  bool operator==(const SimCredit&) const = default;
};

/// motorControl → simulator: what the motor drivers are told.
struct SimActuation {
  double left_wheel_rad_s = 0.0;
  double right_wheel_rad_s = 0.0;
  double roll_rad_s = 0.0;

  bool operator==(const SimActuation&) const = default;
};

/// simulator → motorControl: what the encoders read.
struct SimEncoders {
  StampNs stamp_ns = 0;
  double left_wheel_rad = 0.0;
  double right_wheel_rad = 0.0;
  double roll_rad = 0.0;
  double roll_rad_s = 0.0;

  bool operator==(const SimEncoders&) const = default;
};

/// simulator → evaluation only. No component may read it.
struct GroundTruth {
  StampNs stamp_ns = 0;
  Pose2 T_world_base;
  std::uint32_t collisions = 0;
  double path_length_m = 0.0;

  bool operator==(const GroundTruth&) const = default;
};

}  // namespace enfilade
