// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "interfaces/model/motion.hpp"

namespace enfilade::motor_control {

struct SweepControllerConfig {
  double lowest_rad = -1.5707963267948966;  ///< strokes are clamped to this range
  double highest_rad = 1.5707963267948966;
  double overrun_rad = 0.15;         ///< the motor may go this far beyond either end, > 0
  double max_speed_rad_s = 2.0;      ///< while no stroke is under way, > 0
  double acceleration_rad_s2 = 8.0;  ///< > 0
  double settle_s = 0.06;  ///< before a stroke's first end is reached the speed is steady for this long, > 0
  double tolerance_rad = 0.01;  ///< parked when this close, > 0
};

/// What became of a sweep command.
enum class SweepVerdict { kAccepted, kKnown, kInvalid };

/// Leads the roll motor through a sweep: to the nearer end of the range as fast as may be, a little beyond
/// it, and then at one constant speed across the range. The stroke between the ends has no ramps in it: these
/// lie in the overrun.
///
/// Fed with every encoder reading (`observe`); `speed` gives the rate to drive at.
class SweepController {
 public:
  explicit SweepController(const SweepControllerConfig& config);

  /// Starts a command. Ids only ever grow: one not above the last accepted is known. A range or speed that is
  /// not a number, or an empty range, is invalid. The speed is lowered to what the overrun leaves room to
  /// reach.
  SweepVerdict command(const SweepCommand& command);
  /// Where the motor is; in the order of stamps. Finds the moments at which the stroke's ends are passed,
  /// between readings.
  void observe(StampNs stamp_ns, double angle_rad);
  /// The rate to drive at for the next `dt_s`.
  double speed(double dt_s);
  /// Begins the sweep that is under way anew, from standstill: what was scanned of it has a hole.
  void restart();

  std::uint32_t sweep_id() const { return sweep_id_; }
  SweepPhase phase() const { return phase_; }
  StampNs sweep_start_ns() const { return start_ns_; }
  StampNs sweep_end_ns() const { return end_ns_; }
  /// The fastest stroke that the overrun allows.
  double max_stroke_speed_rad_s() const;

 private:
  struct Stroke {
    double low_rad = 0.0, high_rad = 0.0, speed_rad_s = 0.0;
    double direction = 0.0;  ///< +1 low to high, -1 high to low, 0 not chosen yet

    double first_rad() const { return direction > 0 ? low_rad : high_rad; }
    double last_rad() const { return direction > 0 ? high_rad : low_rad; }
  };

  double run_up_rad() const;
  double towards(double target_rad) const;
  void begin_approach();
  void find_crossings(StampNs stamp_ns, double angle_rad);

  SweepControllerConfig config_;
  std::uint32_t sweep_id_ = 0;
  SweepPhase phase_ = SweepPhase::kParked;
  bool running_up_ = false;  ///< the approach is over, the stroke's first end not reached yet
  Stroke stroke_;
  std::optional<double> park_rad_;
  StampNs start_ns_ = 0, end_ns_ = 0;
  StampNs seen_ns_ = 0;
  std::optional<double> angle_rad_;
  double speed_rad_s_ = 0.0;
};

}  // namespace enfilade::motor_control
