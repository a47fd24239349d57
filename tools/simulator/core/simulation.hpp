// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "interfaces/model/simulation.hpp"
#include "tools/simulator/core/body.hpp"
#include "tools/simulator/core/drive.hpp"
#include "tools/simulator/core/range_finder.hpp"
#include "tools/simulator/core/roll_motor.hpp"
#include "tools/simulator/core/traffic.hpp"

namespace enfilade::simulator {

struct SimulationConfig {
  std::uint64_t seed = 1;
  BodyConfig body;
  DriveConfig drive;
  RollMotorConfig roll;
  RangeFinderConfig laser;
  double command_timeout_s = 0.25;  ///< both motors stop when no command came for so long; 0 = they never do
};

/// The world and the robot in it. Time goes in steps of kStep_ns from 0; the same world, config and commands
/// give the same outputs.
class Simulation {
 public:
  static constexpr StampNs kStep_ns = 5'000'000;

  struct Step {
    SimEncoders encoders;
    std::optional<LaserScan> scan;  ///< the line completed in this step
  };

  /// Throws std::invalid_argument where the robot does not fit at the start.
  Simulation(const World& world, const SimulationConfig& config);

  void actuate(const SimActuation& actuation);
  Step step();

  StampNs now_ns() const { return sensor_.stamp_ns; }
  SimEncoders encoders() const;
  GroundTruth ground_truth() const;
  const WorldTruth& world_truth() const { return truth_; }

 private:
  WorldTruth truth_;
  Random random_;
  RayScene scene_;
  Traffic traffic_;
  Body body_;
  Drive drive_;
  RollMotor roll_;
  RangeFinder laser_;
  SensorState sensor_;
  double path_length_m_ = 0.0;
  StampNs command_timeout_ns_, commanded_ns_ = 0;
};

}  // namespace enfilade::simulator
