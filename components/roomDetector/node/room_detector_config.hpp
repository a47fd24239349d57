// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/roomDetector/core/room_detector.hpp"
#include "interfaces/runtime/config.hpp"

namespace enfilade::room_detector {

struct RoomDetectorNodeConfig {
  PeriodConfig period{.compute_s = 0.25};
  bool every_line = true;             ///< an estimate for each scan line beside those of the period
  double diagnostics_period_s = 1.0;  ///< room_diagnostics is published at most this often
  int search_threads = 2;             ///< at most that work at one search; no more than there are processors
  RoomDetectorConfig detector;
};

void bind(ConfigBinder& c, RoomDetectorNodeConfig& config);

}  // namespace enfilade::room_detector
