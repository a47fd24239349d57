// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "interfaces/geometry/pose2.hpp"
#include "interfaces/model/sensing.hpp"

namespace enfilade::grid_builder {

struct OdometryBufferConfig {
  int max_samples = 500;           ///< how many samples are remembered, ≥ 2 (10 s at 50 Hz)
  double max_gap_s = 0.5;          ///< no pose is made up between samples farther apart
  double still_linear_m_s = 0.02;  ///< up to these speeds the base counts as standing
  double still_angular_rad_s = 0.02;
  double fastest_linear_m_s = 2.0;  ///< a base that seems faster was counted from another origin
  double fastest_angular_rad_s = 4.0;
};

/// Where the base was at one moment.
struct BaseMoment {
  Pose2 T_odom_base;
  bool moving = false;
};

/// The recent path of the base; tells its pose at a stamp by interpolation.
class OdometryBuffer {
 public:
  explicit OdometryBuffer(const OdometryBufferConfig& config);

  /// Samples that are not newer than the newest are ignored.
  void add(const Odometry& sample);
  void clear() { samples_.clear(); }

  /// Whether a sample at or after `stamp_ns` has come, so that waiting is over.
  bool reaches(StampNs stamp_ns) const { return !samples_.empty() && samples_.back().stamp_ns >= stamp_ns; }
  /// Whether no base is so fast as to have come here since the newest sample, or nobody knows, since nothing
  /// was heard for too long: the sample may be of another boot of the odometry.
  bool is_break(const Odometry& sample) const;
  /// Nothing where the stamp lies outside what is remembered, or in a gap.
  std::optional<BaseMoment> find_moment(StampNs stamp_ns) const;

 private:
  struct Sample {
    StampNs stamp_ns = 0;
    BaseMoment moment;
  };

  OdometryBufferConfig config_;
  std::deque<Sample> samples_;
};

}  // namespace enfilade::grid_builder
