// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "components/gridBuilder/core/waiting_lines.hpp"
#include "interfaces/geometry/rectangle.hpp"

namespace enfilade::grid_builder {

struct ScanRegistrarConfig {
  bool register_scans = true;  ///< false: T_zone_odom stays the identity
  double from_m = 0.3;         ///< returns at these heights may lie on a wall
  double to_m = 2.4;
  double first_gate_m = 0.25;  ///< returns farther from a wall do not belong to it (Tukey), at first …
  double last_gate_m = 0.04;   ///< … and at last
  double corner_m = 0.15;      ///< returns so near a corner may belong to either wall and count for none
  double sigma_m = 0.02;       ///< of a return about its wall: noise of the sensor and of the model
  double max_sigma_m = 0.003;  ///< a pose less sure than this …
  double max_sigma_deg = 0.1;  ///< … or this is not settled
  double min_share = 0.5;      ///< of the returns near walls that must lie on them
  double max_shift_m = 0.25;   ///< a correction beyond these is a mistake
  double max_turn_deg = 4.0;
  double moved_m = 0.005;    ///< the robot stands elsewhere than before if it went so far …
  double moved_deg = 0.2;    ///< … or turned so much
  int max_held_lines = 100;  ///< lines that wait for the pose to be settled
};

/// A line and where odometry says it was taken.
struct PlacedLine {
  BaseLine line;
  Pose2 T_odom_base;
};

/// Owns T_zone_odom: at each place where the robot stands, the returns of its first lines are fitted to the
/// walls of the room as known when it came there (r(i+1) against r(i) of eq. 18–19, sizes held), and only
/// then are those lines fused. So the errors of odometry between two places do not smear the walls.
class ScanRegistrar {
 public:
  explicit ScanRegistrar(const ScanRegistrarConfig& config);

  /// Lines that may be fused now, in order, at T_zone_odom(). `walls` is the room of this moment, if one is
  /// known.
  std::vector<PlacedLine> take(PlacedLine line, const std::optional<Rectangle>& walls);
  /// The lines that still wait: nothing more comes to settle their pose.
  std::vector<PlacedLine> give_up();
  bool waits() const { return !held_.empty(); }

  /// The lines of a grid that is no more are forgotten.
  void forget_lines();
  /// Odometry counts from another origin.
  void forget_odometry();

  const Pose2& T_zone_odom() const { return T_zone_odom_; }

 private:
  bool stands_elsewhere(const Pose2& T_odom_base) const;
  std::optional<Pose2> register_held() const;

  ScanRegistrarConfig config_;
  Pose2 T_zone_odom_;
  std::optional<Pose2> stand_;      ///< T_odom_base of the place under way
  std::optional<Rectangle> model_;  ///< when the robot came there; none once the place is settled
  std::vector<PlacedLine> held_;
};

}  // namespace enfilade::grid_builder
