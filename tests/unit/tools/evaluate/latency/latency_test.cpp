// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/latency/latency.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tools/evaluate/latency/latency_report.hpp"

namespace enfilade::evaluate {
namespace {

constexpr ArrivalNs kMs = 1'000'000;

/// A line at `stamp` that ends 19 later; joint samples every 5. Stamps count in ms, arrivals too.
void add_line(LatencyRecording& recording, StampNs stamp, ArrivalNs completed) {
  recording.scans.push_back({stamp, stamp + 19});
  recording.joints.push_back({stamp + 15, (completed - 5) * kMs});
  recording.joints.push_back({stamp + 20, completed * kMs});
  recording.points.push_back({stamp, (completed + 1) * kMs});
  recording.changes.push_back({stamp, (completed + 3) * kMs});
}

TEST(LatencyFigures, CountFromTheJointSampleAfterTheLastBeam) {
  LatencyRecording recording;
  add_line(recording, 100, 1000);
  recording.estimates.push_back({75, 1002 * kMs});  // of the line before
  recording.estimates.push_back({100, 1007 * kMs});
  const LatencyFigures figures = latency_figures(recording);
  EXPECT_EQ(figures.lines, 1u);
  EXPECT_EQ(figures.own_estimates, 1u);
  EXPECT_DOUBLE_EQ(figures.laser.max_ms, 1.0);
  EXPECT_DOUBLE_EQ(figures.grid.max_ms, 2.0);
  EXPECT_DOUBLE_EQ(figures.detector.max_ms, 4.0);
  EXPECT_DOUBLE_EQ(figures.overall.p50_ms, 7.0);
}

TEST(LatencyFigures, OfALineWithoutAnEstimateOfItsOwnAreThoseOfTheNextOne) {
  LatencyRecording recording;
  add_line(recording, 100, 1000);
  add_line(recording, 125, 1025);
  recording.estimates.push_back({125, 1030 * kMs});
  const LatencyFigures figures = latency_figures(recording);
  EXPECT_EQ(figures.lines, 2u);
  EXPECT_EQ(figures.own_estimates, 1u);
  EXPECT_DOUBLE_EQ(figures.overall.max_ms, 30.0);
}

TEST(LatencyFigures, LeaveOutLinesThatWereNotFusedOrNotEstimatedYet) {
  LatencyRecording recording;
  add_line(recording, 100, 1000);
  recording.changes.clear();
  recording.estimates.push_back({100, 1010 * kMs});
  add_line(recording, 125, 1025);
  EXPECT_EQ(latency_figures(recording).lines, 0u);
  EXPECT_EQ(latency_figures({}).lines, 0u);
}

TEST(LatencyFigures, TakeSharesByNearestRank) {
  LatencyRecording recording;
  for (int i = 1; i <= 200; ++i) {
    add_line(recording, 1000 * i, 1000 * i);
    recording.estimates.push_back({1000 * i, (1000 * i + i) * kMs});
  }
  const LatencyShares overall = latency_figures(recording).overall;
  EXPECT_DOUBLE_EQ(overall.p50_ms, 100.0);
  EXPECT_DOUBLE_EQ(overall.p90_ms, 180.0);
  EXPECT_DOUBLE_EQ(overall.p99_ms, 198.0);
  EXPECT_DOUBLE_EQ(overall.max_ms, 200.0);
}

TEST(LatencyReport, HoldsEveryHopOfEveryTransport) {
  const LatencyReport report{.parts = {{"udp", {.lines = 3, .overall = {.p99_ms = 7.5}}}}, .load = 0.5};
  const auto json = nlohmann::json::parse(to_json(report));
  EXPECT_EQ(json["udp"]["lines"], 3);
  EXPECT_EQ(json["udp"]["overall_ms"]["p99"], 7.5);
  EXPECT_EQ(json["udp"]["gridBuilder_ms"]["max"], 0.0);
  EXPECT_EQ(json["load"], 0.5);
  EXPECT_NE(to_table(report).find("7.50"), std::string::npos);
}

}  // namespace
}  // namespace enfilade::evaluate
