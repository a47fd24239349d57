// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/evaluate/latency/latency.hpp"
#include "tools/launch/settings.hpp"

namespace enfilade::evaluate {

struct LatencyRunConfig {
  std::string world;      ///< file
  double seconds = 20.0;  ///< of wall time, from the first estimate on
  double step_deg = 1.0;  ///< between two lines
  int domain = 0;         ///< of DDS; nobody else may use it
  bool shared_memory = true;
  Settings settings;
};

/// Starts simulator, motorControl, laser3D, gridBuilder, roomDetector and topoGraph as processes, sweeps in
/// the explorer's stead while the robot stands, and notes what comes when. Throws std::runtime_error where no
/// estimate comes, or a process is lost.
LatencyRecording record_latency(const LatencyRunConfig& config);

}  // namespace enfilade::evaluate
