// SPDX-License-Identifier: Apache-2.0
#include <span>

#include "components/roomDetector/core/rectangle_search.hpp"
#include "tests/benchmark/perception/crew_runner.hpp"
#include "tests/benchmark/perception/fused_building.hpp"
#include "tests/benchmark/perception/random_scans.hpp"
#include "tests/benchmark/perception/timing.hpp"

/// The exact argmax of H_r from scratch (`gaps` counts the answers left unproven): in simulated rooms and in
/// real buildings fused into one grid at 0.05 m and 1°, and at the resolution of the paper's experiment.
namespace enfilade::bench {
namespace {

using namespace room_detector;

constexpr HoughConfig kPaperBins{.theta_step_deg = 5.0, .step_m = 0.27};

void argmax(benchmark::State& state, std::span<const SearchInput> inputs, const HoughConfig& hough,
            SearchMethod method = SearchMethod::kExact, const TaskRunner& runner = deployed_runner()) {
  InputTimes times(runner.workers > 1 ? wall_ms : thread_ms);
  double gaps = 0.0, planes = 0.0, expansions = 0.0;
  for (auto _ : state) {
    gaps = planes = expansions = 0.0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      state.PauseTiming();
      const HoughSpace space = inputs[i].space(hough);
      RectangleSearch search({.search = method, .max_expansions = kPatientExpansions}, hough, runner);
      state.ResumeTiming();
      std::optional<SearchResult> found;
      times.measure(i, [&] { found = search.find_best(space, inputs[i].robot); });
      if (!found) continue;
      gaps += found->gap > 0;
      planes += found->planes_opened;
      expansions += found->expansions;
    }
  }
  times.report(state);
  state.counters["gaps"] = gaps;
  state.counters["mean_planes"] = planes / static_cast<double>(std::max<std::size_t>(1, inputs.size()));
  state.counters["mean_expansions"] =
      expansions / static_cast<double>(std::max<std::size_t>(1, inputs.size()));
}

void fused(benchmark::State& state, const TaskRunner& runner) {
  static const FusedBuildings buildings = fused_inputs(HoughConfig{});
  state.SetLabel(buildings.label);
  argmax(state, buildings.inputs, HoughConfig{}, SearchMethod::kExact, runner);
}

const bool kRegistered = [] {
  const auto add = [](const char* name, auto run) {
    benchmark::RegisterBenchmark(name, run)->Unit(benchmark::kMillisecond);
  };
  add("Argmax/simulated", [](benchmark::State& s) { argmax(s, simulated_inputs().evidence, {}); });
  add("Argmax/simulated_paper", [](benchmark::State& s) { argmax(s, simulated_inputs().paper, {}); });
  add("Argmax/fused", [](benchmark::State& s) { fused(s, deployed_runner()); });
  add("Argmax/fused_one_thread", [](benchmark::State& s) { fused(s, {}); });
  add("Argmax/paper_bins",
      [](benchmark::State& s) { argmax(s, simulated_inputs().paper, kPaperBins, SearchMethod::kExact, {}); });
  // What the one above is a fraction of: the paper's loops, on four of the inputs.
  add("Argmax/paper_bins_literal", [](benchmark::State& s) {
    argmax(s, std::span(simulated_inputs().paper).first(4), kPaperBins, SearchMethod::kLiteral, {});
  });
  return true;
}();

}  // namespace
}  // namespace enfilade::bench
