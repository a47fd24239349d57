// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/perception/evaluation.hpp"

#include <algorithm>
#include <chrono>
#include <functional>

#include "tools/evaluate/perception/in_parallel.hpp"
#include "tools/evaluate/perception/range_calibration.hpp"

namespace enfilade::evaluate {
namespace {

constexpr double kUsableIou = 0.8;  // sizes are compared where the rectangle is the room, if not exactly

constexpr double kCalibrationRoom_m = 4.5;

/// Answers of one score to many trials.
using Answers = std::vector<Answer>;

struct Both {
  Answers paper, evidence;
};

/// In the order of the rooms, whichever was ready first.
Both run_all(int rooms, const std::function<TrialConfig(int)>& config_of) {
  std::vector<TrialResult> results(static_cast<std::size_t>(rooms));
  in_parallel(rooms, [&](int i) { results[static_cast<std::size_t>(i)] = run_trial(config_of(i)); });
  Both all;
  for (TrialResult& result : results) {
    all.paper.push_back(std::move(result.paper));
    all.evidence.push_back(std::move(result.evidence));
  }
  return all;
}

std::optional<double> share(double part, double whole) {
  return whole > 0.0 ? std::optional(part / whole) : std::nullopt;
}

std::optional<double> right_after(const Answers& answers, std::size_t sweeps) {
  double right = 0.0, all = 0.0;
  for (const Answer& answer : answers) {
    if (answer.iou.size() < sweeps) continue;
    all += 1.0;
    right += answer.iou[sweeps - 1] > 0.9;
  }
  return share(right, all);
}

std::optional<double> quantile(std::vector<double> values, double q) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1,
                         static_cast<std::size_t>(q * static_cast<double>(values.size())))];
}

void add_rates(Figures& figures, const Answers& answers) {
  figures.iou90_after_1 = right_after(answers, 1);
  figures.iou90_after_2 = right_after(answers, 2);
  figures.iou90_after_4 = right_after(answers, 4);
}

void add_sizes(Figures& figures, const Answers& answers) {
  std::vector<double> errors;
  double nees_sum = 0.0, nees_count = 0.0;
  for (const Answer& answer : answers) {
    if (!answer.is_right(kUsableIou)) continue;
    errors.insert(errors.end(), answer.size_errors_m.begin(), answer.size_errors_m.end());
    if (!answer.nees) continue;
    nees_sum += *answer.nees;
    nees_count += 1.0;
  }
  figures.size_error_median_m = quantile(errors, 0.5);
  figures.size_error_p95_m = quantile(errors, 0.95);
  figures.nees_mean = share(nees_sum, nees_count);
  if (nees_count > 0.0) figures.nees_rooms = nees_count;
}

void add_doors(Figures& figures, const Answers& answers) {
  DoorTally tally;
  for (const Answer& answer : answers) tally.add(answer.doors);
  figures.door_precision = share(tally.right, tally.reported);
  figures.door_recall = share(tally.found, tally.visible);
  figures.door_edge_error_median_m = quantile(tally.edge_errors_m, 0.5);
}

Figures figures_of(const Answers& answers) {
  Figures figures;
  add_rates(figures, answers);
  add_sizes(figures, answers);
  add_doors(figures, answers);
  return figures;
}

class Experiment {
 public:
  explicit Experiment(const PerceptionConfig& config) : config_(config) {}

  void furnished(PerceptionReport& report) const {
    const Both plain = run_all(config_.rooms, [&](int i) { return trial(i); });
    const auto fill = [](Figures& figures, const Answers& answers) {
      add_rates(figures, answers);
      add_doors(figures, answers);
    };
    fill(report.paper, plain.paper);
    fill(report.evidence, plain.evidence);
  }

  void sizes(PerceptionReport& report) const {
    const int rooms = std::max(1, config_.rooms / 2);
    const Both turned = run_all(rooms, [&](int i) { return with_odometry_error(trial(i)); });
    add_sizes(report.paper, turned.paper);
    add_sizes(report.evidence, turned.evidence);
    report.evidence.nees_mean.reset();
    report.evidence.nees_rooms.reset();
    report.hard_cases.push_back(
        {"odometry 1 deg / 20 mm", rooms, figures_of(turned.paper), figures_of(turned.evidence)});
  }

  void collinear(PerceptionReport& report) const {
    const Both joined = run_all(std::max(1, config_.rooms / 3), [&](int i) {
      TrialConfig t = trial(i);
      t.hardship = Hardship::kCollinear;
      t.neighbour_sweeps = 2;
      t.sweeps = 2;
      return t;
    });
    report.paper.iou90_collinear = right_after(joined.paper, 2);
    report.evidence.iou90_collinear = right_after(joined.evidence, 2);
  }

  /// Consistency under all that the covariance stands for: odometry errors and a range bias, which is spread
  /// evenly over what is stated.
  void consistency(PerceptionReport& report) const {
    const Both biased = run_all(config_.rooms, [&](int i) {
      TrialConfig t = with_odometry_error(trial(i));
      t.sweeps = 2;
      t.with_paper = false;
      t.range_bias_m = config_.stated_bias_m * ((2.0 * i + 1.0) / config_.rooms - 1.0);
      return t;
    });
    Figures figures;
    add_sizes(figures, biased.evidence);
    report.evidence.nees_mean = figures.nees_mean;
    report.evidence.nees_rooms = figures.nees_rooms;
  }

  void hard(PerceptionReport& report, const std::string& name,
            const std::function<void(TrialConfig&, int)>& change) const {
    const int rooms = std::max(1, config_.rooms / 10);
    const Both all = run_all(rooms, [&](int i) {
      TrialConfig t = trial(i);
      change(t, i);
      return t;
    });
    report.hard_cases.push_back({name, rooms, figures_of(all.paper), figures_of(all.evidence)});
  }

 private:
  TrialConfig trial(int i) const { return {.seed = 10'000 * config_.seed + static_cast<std::uint64_t>(i)}; }
  TrialConfig with_odometry_error(TrialConfig t) const {
    t.turn_sigma_deg = config_.turn_sigma_deg;
    t.turn_sigma_m = config_.turn_sigma_m;
    return t;
  }

  PerceptionConfig config_;
};

}  // namespace

PerceptionReport evaluate_perception(const PerceptionConfig& config) {
  const auto start = std::chrono::steady_clock::now();
  PerceptionReport report{.config = config};
  const Experiment experiment(config);
  experiment.furnished(report);
  experiment.collinear(report);
  experiment.sizes(report);
  experiment.consistency(report);
  const double bias = config.stated_bias_m;
  const auto kind = [](Hardship hardship) {
    return [hardship](TrialConfig& t, int) { t.hardship = hardship; };
  };
  experiment.hard(report, "low walls, no ceiling", kind(Hardship::kLowWalls));
  experiment.hard(report, "full-height cupboards", kind(Hardship::kCupboards));
  experiment.hard(report, "glass wall", kind(Hardship::kGlass));
  experiment.hard(report, "two people walking", kind(Hardship::kPeople));
  experiment.hard(report, "a line each 3 deg", [](TrialConfig& t, int) { t.line_step_deg = 3.0; });
  experiment.hard(report, "range bias +-30 mm",
                  [bias](TrialConfig& t, int i) { t.range_bias_m = i % 2 == 0 ? bias : -bias; });
  const auto longer = calibrate_simulated_range(kCalibrationRoom_m, bias, config.seed);
  const auto shorter = calibrate_simulated_range(kCalibrationRoom_m, -bias, config.seed);
  if (longer && shorter)
    experiment.hard(report, "the same, calibrated", [&](TrialConfig& t, int i) {
      t.range_bias_m = i % 2 == 0 ? bias : -bias;
      t.assumed_bias_m = i % 2 == 0 ? longer->bias_m : shorter->bias_m;
    });
  report.wall_time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace enfilade::evaluate
