// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "interfaces/model/zone_tag.hpp"

namespace enfilade {

/// rt/cmd_vel: forward and turning speed of a differential base.
struct VelocityCommand {
  double linear_m_s = 0.0;
  double angular_rad_s = 0.0;

  bool operator==(const VelocityCommand&) const = default;
};

enum class SweepAction : std::uint8_t {
  kSweep,  ///< go to the nearer end of the range, then travel to the other one at the speed asked for
  kPark,   ///< go to `from_rad` and stay
};

/// What the sweep motor shall do. The angle between two scan lines is speed ÷ line rate.
struct SweepCommand {
  std::uint32_t sweep_id =
      0;  ///< chosen by the writer; a command already carried out or under way is ignored
  SweepAction action = SweepAction::kPark;
  double from_rad = 0.0;
  double to_rad = 0.0;
  double speed_rad_s = 0.0;

  bool operator==(const SweepCommand&) const = default;
};

enum class SweepPhase : std::uint8_t { kParked, kApproaching, kSweeping, kDone };

/// State of the actuators; latched, republished on every change of phase and at a low rate.
struct MotorState {
  StampNs stamp_ns = 0;
  std::uint32_t odom_boot = 0;
  std::uint32_t sweep_id = 0;  ///< of the last command accepted
  SweepPhase phase = SweepPhase::kParked;
  StampNs sweep_start_ns = 0;  ///< when the motor left the first end of the range; 0 before that
  StampNs sweep_end_ns = 0;    ///< when it reached the other end; 0 before that
  bool base_moving = false;

  bool operator==(const MotorState&) const = default;
};

}  // namespace enfilade
