// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>

#include "interfaces/model/zone_tag.hpp"

namespace enfilade::laser_3d {

struct RollInterpolatorConfig {
  int history = 400;       ///< joint samples kept, >= 2
  double max_gap_s = 0.1;  ///< samples further apart than this say nothing about the time between them, > 0
};

/// What the joint samples say about a stretch of time.
enum class Coverage {
  kKnown,    ///< the angle is known all along
  kNotYet,   ///< the newest sample is older than the stretch's end
  kUnknown,  ///< the samples begin too late, or have a gap there: it never will be known
};

/// The roll angle at any time between two samples of the joint, by linear interpolation.
class RollInterpolator {
 public:
  explicit RollInterpolator(const RollInterpolatorConfig& config);

  /// A sample that is not newer than the last one is ignored.
  void add(StampNs stamp_ns, double roll_rad);
  /// Nothing where the time is not between two samples, or these are too far apart.
  std::optional<double> angle_at(StampNs stamp_ns) const;
  Coverage coverage(StampNs from_ns, StampNs to_ns) const;

 private:
  struct Sample {
    StampNs stamp_ns = 0;
    double roll_rad = 0.0;
  };

  std::deque<Sample>::const_iterator first_not_before(StampNs stamp_ns) const;

  RollInterpolatorConfig config_;
  std::deque<Sample> samples_;  ///< by time
};

}  // namespace enfilade::laser_3d
