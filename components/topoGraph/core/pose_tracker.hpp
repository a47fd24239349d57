// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "interfaces/geometry/rectangle.hpp"

namespace enfilade::topo_graph {

/// Eq. 18–19: Δα = α(i+1) − α(i) and Δt = c(i+1) − R(Δα)·c(i). The result D = (Δt, Δα) maps the room's old
/// frame to its new one: `after = D * before`. Both are in the zone frame.
Pose2 model_deviation(const Pose2& before, const Pose2& after);

/// The poses under which `seen` is the same set of points with sides named as those of `reference`: quarter
/// turns apart for near-squares, half turns otherwise, none where the sizes do not agree.
std::vector<Pose2> namings(const Rectangle& reference, const Rectangle& seen, double max_size_difference_m);

struct PoseTrackerConfig {
  double max_size_difference_m = 0.15;  ///< of a side, between the estimate and the stored room
  double max_shift_m =
      0.5;  ///< of the room, from one estimate to the next, beside what its turn about an end does
  double max_turn_rad = 0.2618;   ///< 15°: below 45°, where a quarter turn more would be as near
  double min_shift_m = 0.001;     ///< less than both of these is noise: nothing is corrected
  double min_turn_rad = 0.00035;  ///< 0.02°
};

/// The robot's odometric error, seen as a motion of the room's frame (section IV).
class PoseTracker {
 public:
  /// Throws std::invalid_argument where the configuration makes no sense.
  explicit PoseTracker(const PoseTrackerConfig& config);

  /// D of eq. 18–19 modulo the rectangle's symmetry; nothing where `seen` cannot be the same room a little
  /// displaced.
  std::optional<Pose2> deviation(const Rectangle& reference, const Rectangle& seen) const;

  /// Whether D moves the room's centre or axes by more than noise.
  bool is_significant(const Rectangle& reference, const Pose2& deviation) const;

  const PoseTrackerConfig& config() const { return config_; }

 private:
  PoseTrackerConfig config_;
};

}  // namespace enfilade::topo_graph
