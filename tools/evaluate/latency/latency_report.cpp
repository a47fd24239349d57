// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/latency/latency_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "interfaces/model/counted.hpp"

namespace enfilade::evaluate {
namespace {

using LatencyJson = nlohmann::ordered_json;

std::string hop_row(const char* name, const LatencyShares& shares) {
  return fmt::format("  {:<48} {:>7.2f} {:>7.2f} {:>7.2f} {:>8.2f}\n", name, shares.p50_ms, shares.p90_ms,
                     shares.p99_ms, shares.max_ms);
}

LatencyJson shares_json(const LatencyShares& shares) {
  return {{"p50", shares.p50_ms}, {"p90", shares.p90_ms}, {"p99", shares.p99_ms}, {"max", shares.max_ms}};
}

}  // namespace

std::string to_table(const LatencyReport& report) {
  std::string text;
  for (const auto& [transport, figures] : report.parts) {
    text += fmt::format("{}: {}, {} with an estimate of their own\n", transport,
                        counted(figures.lines, "line"), figures.own_estimates);
    text += fmt::format("  {:<48} {:>7} {:>7} {:>7} {:>8}\n", "ms", "p50", "p90", "p99", "max");
    text += hop_row("joint sample -> points (laser3D)", figures.laser);
    text += hop_row("points -> grid change (gridBuilder)", figures.grid);
    text += hop_row("grid change -> room estimate (roomDetector)", figures.detector);
    text += hop_row("joint sample -> room estimate", figures.overall);
  }
  return text + fmt::format("load {:.1f} on {} processors\n", report.load, report.processors);
}

std::string to_json(const LatencyReport& report) {
  LatencyJson json;
  for (const auto& [transport, figures] : report.parts) {
    json[transport] = {{"lines", figures.lines},
                       {"own_estimates", figures.own_estimates},
                       {"laser3D_ms", shares_json(figures.laser)},
                       {"gridBuilder_ms", shares_json(figures.grid)},
                       {"roomDetector_ms", shares_json(figures.detector)},
                       {"overall_ms", shares_json(figures.overall)}};
  }
  json["load"] = report.load;
  json["processors"] = report.processors;
  return json.dump(2) + "\n";
}

}  // namespace enfilade::evaluate
