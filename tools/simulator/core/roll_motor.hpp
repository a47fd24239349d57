// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace enfilade::simulator {

struct RollMotorConfig {
  double max_rad_s = 6.0;      ///< > 0
  double max_rad_s2 = 60.0;    ///< > 0
  double end_rad = 1.75;       ///< mechanical stop on both sides, > 0
  int steps_per_turn = 65536;  ///< of its encoder; 0 = no quantisation
};

/// The motor that rolls the laser about the base's x axis; driven by speed.
class RollMotor {
 public:
  explicit RollMotor(const RollMotorConfig& config);

  void command(double rad_s);
  void step(double dt_s);

  double true_rad() const { return angle_rad_; }
  double speed_rad_s() const { return speed_rad_s_; }
  /// What the encoder reads.
  double read_rad() const;

 private:
  RollMotorConfig config_;
  double command_rad_s_ = 0.0;
  double speed_rad_s_ = 0.0;
  double angle_rad_ = 0.0;
};

}  // namespace enfilade::simulator
