// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "components/roomDetector/core/room_detector.hpp"
#include "tools/evaluate/perception/room_case.hpp"

namespace enfilade::evaluate {

/// One way of standing in one room and looking around.
struct TrialConfig {
  std::uint64_t seed = 1;
  Hardship hardship = Hardship::kNone;
  int sweeps = 4;               ///< in place, a quarter turn apart
  bool with_paper = true;       ///< whether the paper's score is asked too
  int neighbour_sweeps = 0;     ///< taken next door before, into the same grid
  double line_step_deg = 1.0;   ///< of roll between two scan lines
  double turn_sigma_deg = 0.0;  ///< what odometry errs by in each turn …
  double turn_sigma_m = 0.0;    ///< … each way
  double range_bias_m = 0.0;    ///< added to every range
  double assumed_bias_m = 0.0;  ///< subtracted again (laser3D's range_bias_m)
};

/// Doors of right rooms, over all trials they are added up for.
struct DoorTally {
  int reported = 0, right = 0;  ///< reported as open, and those that are doors
  int visible = 0, found = 0;   ///< true doors of which enough could be seen, and those reported as open
  std::vector<double> edge_errors_m;

  void add(const DoorTally& other);
};

/// What one way of looking at the grid made of it.
struct Answer {
  std::vector<double> iou;            ///< after each sweep in the room; 0 where nothing was found
  std::vector<double> size_errors_m;  ///< |Δw|, |Δh| at the end
  std::optional<double> nees;         ///< eᵀ P⁻¹ e of (α, x_c, y_c, w, h) at the end: 5 in the mean
  DoorTally doors;

  bool is_right(double least_iou = 0.9) const { return !iou.empty() && iou.back() > least_iou; }
};

struct TrialResult {
  Answer paper, evidence;
};

room_detector::RoomDetectorConfig paper_config();
TrialResult run_trial(const TrialConfig& config);

}  // namespace enfilade::evaluate
