// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/explorer/core/observation.hpp"

namespace enfilade::explorer {

struct SweeperConfig {
  double from_rad = radians(-90.0);
  double to_rad = radians(90.0);
  double line_rate_hz = 40.0;
  double repeat_s = 1.0;  ///< a command that the motor does not confirm is sent again
  double spare_s = 10.0;  ///< beyond the stroke's own time before a sweep is given up
  double settle_s = 3.0;  ///< the base is given this long to stand
  int max_attempts = 3;
};

enum class SweepStatus { kRunning, kDone, kFailed };

/// Has the motor make one sweep while the base stands, then parks it with the scan plane level.
class Sweeper {
 public:
  explicit Sweeper(const SweeperConfig& config);

  /// The lines of the sweep will be `step_deg` apart.
  void begin(double step_deg, StampNs now_ns);
  SweepStatus update(const Observation& seen, Decision& decision);
  /// Of the last sweep done.
  StampNs end_ns() const { return end_ns_; }
  StampNs line_period_ns() const { return from_seconds(1.0 / config_.line_rate_hz); }

 private:
  void issue(const Observation& seen, Decision& decision);
  void park(Decision& decision);

  SweeperConfig config_;
  double speed_rad_s_ = 0.0;
  std::uint32_t last_id_ = 0;
  SweepCommand command_;
  bool issued_ = false;
  int attempts_ = 0;
  StampNs begun_ns_ = 0, issued_ns_ = 0, sent_ns_ = 0, end_ns_ = 0;
};

}  // namespace enfilade::explorer
