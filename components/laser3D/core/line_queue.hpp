// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "components/laser3D/core/roll_interpolator.hpp"
#include "interfaces/model/sensing.hpp"

namespace enfilade::laser_3d {

struct LineQueueConfig {
  int capacity = 20;  ///< lines that wait for their angles at most, >= 1
};

/// A scan line and the roll angle at which each beam was taken.
struct RolledLine {
  LaserScan scan;
  std::vector<double> roll_rad;
};

/// Lines wait here until the joint has been sampled at or after their last beam.
class LineQueue {
 public:
  explicit LineQueue(const LineQueueConfig& config);

  /// The oldest waiting line is dropped where there is no room.
  void push(LaserScan scan);
  /// The oldest line, if its angles are known; lines whose angles never will be known are dropped on the way.
  std::optional<RolledLine> pop(const RollInterpolator& roll);

  std::uint64_t dropped() const { return dropped_; }

 private:
  LineQueueConfig config_;
  std::deque<LaserScan> waiting_;
  std::uint64_t dropped_ = 0;
};

/// When beam `beam` of the line was taken.
StampNs beam_stamp_ns(const LaserScan& scan, std::size_t beam);

}  // namespace enfilade::laser_3d
