// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "components/gridBuilder/core/odometry_drift.hpp"
#include "components/gridBuilder/core/waiting_lines.hpp"
#include "components/gridBuilder/core/wall_alignment.hpp"

namespace enfilade::grid_builder {

struct ScanRegistrarConfig {
  bool register_scans = true;  ///< false: T_zone_odom stays the identity
  double from_m = 0.3;         ///< returns at these heights may lie on a wall
  double to_m = 2.4;
  double first_gate_m = 0.25;     ///< returns farther from a wall do not belong to it (Tukey), at first …
  double last_gate_m = 0.04;      ///< … and at last
  double corner_m = 0.15;         ///< returns so near a corner may belong to either wall and count for none
  double sigma_m = 0.02;          ///< of a return about its wall: noise of the sensor and of the model
  double max_sigma_m = 0.003;     ///< a pose less sure than this …
  double max_sigma_deg = 0.1;     ///< … or this is not settled
  double max_wall_sigma_m = 0.1;  ///< a wall of the model less sure than this has not been seen
  double min_share = 0.5;         ///< of the returns near walls that must lie on them
  double moved_m = 0.005;         ///< the robot stands elsewhere than before if it went so far …
  double moved_deg = 0.2;         ///< … or turned so much
  int max_held_lines = 100;       ///< lines that wait for the pose to be settled
  OdometryDriftConfig drift;
};

/// A line and where odometry says it was taken.
struct PlacedLine {
  BaseLine line;
  Pose2 T_odom_base;
};

/// Owns T_zone_odom: at each place where the robot stands, the returns of its first lines are fitted to the
/// walls of the room as known when it came there (r(i+1) against r(i) of eq. 18–19, sizes held), and only
/// then are those lines fused. So the errors of odometry between two places do not smear the walls; what they
/// have in common is learned and taken out on the way.
class ScanRegistrar {
 public:
  explicit ScanRegistrar(const ScanRegistrarConfig& config);

  /// Odometry has come to `T_odom_base`.
  void move(const Pose2& T_odom_base);
  /// Lines that may be fused now, in order, at T_zone_odom(). `walls` is the room of this moment, if one is
  /// known.
  std::vector<PlacedLine> take(PlacedLine line, const std::optional<KnownWalls>& walls);
  /// The lines that still wait, at the best place that they tell: nothing more comes to settle it.
  std::vector<PlacedLine> finish();
  bool waits() const { return !held_.empty(); }

  /// The lines of a grid that is no more are forgotten.
  void forget_lines();
  /// The drift is known from elsewhere.
  void start_from(const Pose2& T_zone_odom) { drift_.start_from(T_zone_odom); }
  /// Odometry counts from another origin.
  void forget_odometry();

  const Pose2& T_zone_odom() const { return drift_.T_zone_odom(); }
  const OdometryDrift& drift() const { return drift_; }

 private:
  bool stands_elsewhere(const Pose2& T_odom_base) const;
  void arrive(const Pose2& T_odom_base, const std::optional<KnownWalls>& walls);
  void settle(bool is_last);
  std::vector<PlacedLine> release();
  std::vector<Point2> held_points() const;
  std::optional<WallAlignment> register_held() const;

  ScanRegistrarConfig config_;
  OdometryDrift drift_;
  std::optional<Pose2> stand_;       ///< T_odom_base of the place under way
  std::optional<KnownWalls> model_;  ///< when the robot came there; none once the place is settled
  std::vector<PlacedLine> held_;
};

}  // namespace enfilade::grid_builder
