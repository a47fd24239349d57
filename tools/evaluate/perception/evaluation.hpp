// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/evaluate/perception/trial.hpp"

namespace enfilade::evaluate {

/// The figures of one score over all rooms; nothing where they are not defined.
struct Figures {
  std::optional<double> iou90_after_1, iou90_after_2, iou90_after_4, iou90_collinear;
  std::optional<double> size_error_median_m, size_error_p95_m;
  std::optional<double> door_precision, door_recall, door_edge_error_median_m;
  std::optional<double> nees_mean, nees_rooms;
};

/// The same rooms, made harder in one way.
struct HardCase {
  std::string name;
  int rooms = 0;
  Figures paper, evidence;
};

struct PerceptionConfig {
  int rooms = 60;
  std::uint64_t seed = 1;
  double turn_sigma_deg = 1.0, turn_sigma_m = 0.02;  ///< of odometry where its error is part of the trial
  double stated_bias_m = 0.03;                       ///< range bias of an uncalibrated sensor, either way
};

struct PerceptionReport {
  PerceptionConfig config;
  double wall_time_s = 0.0;
  Figures paper, evidence;
  std::vector<HardCase> hard_cases;
};

PerceptionReport evaluate_perception(const PerceptionConfig& config);

std::string to_json(const PerceptionReport& report);
std::string to_table(const PerceptionReport& report);
std::string to_markdown(const PerceptionReport& report, const std::string& date);

}  // namespace enfilade::evaluate
