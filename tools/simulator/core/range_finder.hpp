// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "interfaces/model/sensing.hpp"
#include "tools/simulator/core/body.hpp"
#include "tools/simulator/core/random.hpp"
#include "tools/simulator/core/ray_scene.hpp"

namespace enfilade::simulator {

/// A Hokuyo UTM-30LX: 1081 beams over 270°, 40 lines a second, turning at 1440 beam steps a turn.
struct RangeFinderConfig {
  double mount_x_m = 0.10;  ///< the roll axis is the base's x axis through this point
  double mount_y_m = 0.0;
  double mount_z_m = 0.60;
  double range_min_m = 0.1;
  double range_max_m = 30.0;
  double sigma_near_m = 0.01;  ///< range noise up to 10 m, ≥ 0
  double sigma_far_m = 0.03;   ///< range noise beyond, ≥ 0
  double bias_m = 0.0;         ///< added to every range
  double dropout_probability = 0.002;
  double mixed_pixel_probability = 0.3;  ///< that a beam at a depth edge returns something between both sides
  double mixed_pixel_min_jump_m = 0.10;
  double mixed_pixel_max_jump_m = 2.0;  ///< echoes further apart are told apart by the sensor
};

/// Where sensor and base are at one moment.
struct SensorState {
  StampNs stamp_ns = 0;
  Pose2 T_world_base;
  double roll_rad = 0.0;
};

class RangeFinder {
 public:
  static constexpr int kBeams = 1081;
  static constexpr int kBeamsPerTurn = 1440;
  static constexpr StampNs kLine_ns = 25'000'000;

  RangeFinder(const RangeFinderConfig& config, const BodyConfig& body);

  /// Takes the beams that fall into [from, to), each at its own interpolated pose and roll. Returns a line
  /// when its last beam was taken. The first line starts at `stamp` 0; steps must follow each other without a
  /// gap.
  std::optional<LaserScan> sense(const SensorState& from, const SensorState& to, const RayScene& scene,
                                 Random& random);

 private:
  Ray beam(int index, const Pose2& T_world_base, double roll_rad) const;
  /// Where the beam meets the robot's own body; +inf where it does not.
  double own_body_m(int index, double roll_rad) const;
  float measured(int index, Random& random) const;
  double mixed(int index, Random& random) const;
  LaserScan finish(Random& random) const;

  RangeFinderConfig config_;
  BodyConfig body_;
  std::vector<double> cos_, sin_;  ///< of every beam's angle in the scan plane
  StampNs line_start_ns_ = 0;
  int next_beam_ = 0;
  std::vector<float> true_m_;
  std::vector<Ray> rays_;
};

}  // namespace enfilade::simulator
