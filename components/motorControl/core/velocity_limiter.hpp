// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "interfaces/model/motion.hpp"

namespace enfilade::motor_control {

struct VelocityLimiterConfig {
  double max_linear_m_s = 0.5;       ///< > 0
  double max_angular_rad_s = 1.2;    ///< > 0
  double acceleration_m_s2 = 0.6;    ///< speeding up, > 0
  double acceleration_rad_s2 = 2.0;  ///< speeding up, > 0
  double deceleration_m_s2 = 1.0;    ///< slowing down as commanded, > 0
  double deceleration_rad_s2 = 3.0;  ///< slowing down as commanded, > 0
  double brake_m_s2 = 10.0;          ///< slowing down because commands went stale, > 0
  double brake_rad_s2 = 24.0;        ///< slowing down because commands went stale, > 0
};

enum class Slowing { kSmooth, kBrake };

/// Leads the base's speed towards what is commanded, within the limits of speed and acceleration.
class VelocityLimiter {
 public:
  explicit VelocityLimiter(const VelocityLimiterConfig& config);

  /// The speed to drive at for the next `dt_s`. A target beyond the limits is scaled down as a whole, so that
  /// the base keeps to the commanded curve. A target that is not finite means: stand.
  VelocityCommand step(const VelocityCommand& target, double dt_s, Slowing slowing);
  /// The base stands.
  void reset() { speed_ = {}; }
  const VelocityCommand& speed() const { return speed_; }

 private:
  VelocityLimiterConfig config_;
  VelocityCommand speed_;
};

}  // namespace enfilade::motor_control
