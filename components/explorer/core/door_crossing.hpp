// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "components/explorer/core/door_corridor.hpp"
#include "components/explorer/core/observation.hpp"
#include "components/explorer/core/safety_guard.hpp"

namespace enfilade::explorer {

struct DoorCrossingConfig {
  double linear_m_s = 0.20;
  double deceleration_m_s2 = 0.25;
  double angular_rad_s = 0.5;
  double side_gain_per_m = 2.0;  ///< rad of heading towards the line, per metre beside it
  double max_heading_rad = 0.35;
  double turn_gain = 2.5;  ///< rad/s per rad
  double blocked_s = 5.0;
  double timeout_s = 40.0;
};

enum class CrossingStatus { kUnderWay, kDone, kBlocked };

/// Keeps a differential base on the straight line through a door, forwards to get out, backwards to get back.
class DoorCrossing {
 public:
  DoorCrossing(const DoorCrossingConfig& config, const SafetyGuardConfig& guard);

  void begin(const DoorCorridor& corridor, bool backwards, StampNs now_ns);
  CrossingStatus update(const Observation& seen, Decision& decision);

 private:
  VelocityCommand steer(const Pose2& T_line_base, double rest_m) const;

  DoorCrossingConfig config_;
  SafetyGuard guard_;
  DoorCorridor corridor_;
  bool backwards_ = false;
  StampNs begun_ns_ = 0;
  std::optional<StampNs> blocked_since_ns_;
};

}  // namespace enfilade::explorer
