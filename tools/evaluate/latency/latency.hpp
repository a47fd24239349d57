// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "interfaces/model/zone_tag.hpp"

namespace enfilade::evaluate {

/// Wall time of a reader, ns.
using ArrivalNs = std::int64_t;

/// What one reader has got of one scan line and its consequences: what messages tell with their stamps, and
/// when they came.
struct LatencyRecording {
  struct Line {
    StampNs stamp_ns = 0;
    StampNs end_ns = 0;  ///< of its last beam
  };
  struct Arrival {
    StampNs stamp_ns = 0;
    ArrivalNs at_ns = 0;
  };

  std::vector<Line> scans;
  std::vector<Arrival> joints, points, changes, estimates;  ///< in the order of arrival
};

/// Of a number of measurements, in ms, by nearest rank.
struct LatencyShares {
  double p50_ms = 0.0, p90_ms = 0.0, p99_ms = 0.0, max_ms = 0.0;
};

struct LatencyFigures {
  std::size_t lines = 0;          ///< that were fused into the grid and came out in an estimate
  std::size_t own_estimates = 0;  ///< of these, with an estimate of their own: none shared with a later line
  LatencyShares laser;            ///< joint sample that completes the line → its points (laser3D)
  LatencyShares grid;             ///< its points → the change of the grid (gridBuilder)
  LatencyShares detector;         ///< the change → the first estimate that includes the line (roomDetector)
  LatencyShares overall;          ///< joint sample → estimate
};

LatencyFigures latency_figures(const LatencyRecording& recording);

}  // namespace enfilade::evaluate
