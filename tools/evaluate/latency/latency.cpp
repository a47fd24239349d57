// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/latency/latency.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace enfilade::evaluate {
namespace {

using Arrival = LatencyRecording::Arrival;
using Arrivals = std::vector<Arrival>;

/// The first to come whose stamp is right.
std::optional<ArrivalNs> first_with(const Arrivals& arrivals, const std::function<bool(StampNs)>& is_right) {
  const auto found =
      std::ranges::find_if(arrivals, [&](const Arrival& arrival) { return is_right(arrival.stamp_ns); });
  return found == arrivals.end() ? std::nullopt : std::optional(found->at_ns);
}

double ms_between(ArrivalNs from_ns, ArrivalNs to_ns) { return 1e-6 * static_cast<double>(to_ns - from_ns); }

LatencyShares shares_of(std::vector<double> values_ms) {
  if (values_ms.empty()) return {};
  std::ranges::sort(values_ms);
  const auto at = [&values_ms](double share) {
    const double rank = std::ceil(share * static_cast<double>(values_ms.size()));
    return values_ms[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
  };
  return {at(0.5), at(0.9), at(0.99), values_ms.back()};
}

}  // namespace

LatencyFigures latency_figures(const LatencyRecording& recording) {
  LatencyFigures figures;
  std::vector<double> laser, grid, detector, overall;
  for (const LatencyRecording::Line& line : recording.scans) {
    const auto is_line = [&](StampNs stamp_ns) { return stamp_ns == line.stamp_ns; };
    const auto joint = first_with(recording.joints, [&](StampNs s) { return s >= line.end_ns; });
    const auto points = first_with(recording.points, is_line);
    const auto change = first_with(recording.changes, is_line);
    const auto estimate = first_with(recording.estimates, [&](StampNs s) { return s >= line.stamp_ns; });
    if (!joint || !points || !change || !estimate) continue;
    ++figures.lines;
    figures.own_estimates += first_with(recording.estimates, is_line).has_value();
    laser.push_back(ms_between(*joint, *points));
    grid.push_back(ms_between(*points, *change));
    detector.push_back(ms_between(*change, *estimate));
    overall.push_back(ms_between(*joint, *estimate));
  }
  figures.laser = shares_of(laser);
  figures.grid = shares_of(grid);
  figures.detector = shares_of(detector);
  figures.overall = shares_of(overall);
  return figures;
}

}  // namespace enfilade::evaluate
