// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "components/roomDetector/core/room_detector.hpp"
#include "tests/unit/components/roomDetector/sim_room.hpp"

namespace enfilade::room_detector {
namespace {

/// Furnished rooms after two sweeps, made once.
struct Scene {
  ColumnMap map;
  std::vector<ScanHits> hits;
  GridChange change;
  Pose2 T_zone_base;
};

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = [] {
    std::vector<Scene> made;
    for (unsigned seed = 0; seed < 6; ++seed) {
      const test::SimRoom room = test::RandomRooms(seed).next();
      test::SimGrid grid(0.05, seed);
      Scene scene;
      for (const double yaw : {0.3, 0.3 + 0.5 * kPi}) {
        scene.T_zone_base = room.T_zone_room * Pose2{0.0, 0.0, yaw};
        const auto lines = grid.sweep(room, scene.T_zone_base);
        scene.hits.insert(scene.hits.end(), lines.begin(), lines.end());
      }
      scene.change = grid.changes();
      scene.map.clear(0.05);
      scene.map.apply(scene.change.cells);
      made.push_back(std::move(scene));
    }
    return made;
  }();
  return all;
}

/// The argmax alone, at the resolution: 0.05 m and 1°.
void BM_Argmax(benchmark::State& state) {
  const auto score = static_cast<Score>(state.range(0));
  const auto& scene = scenes()[static_cast<std::size_t>(state.range(1))];
  WallBandConfig band_config;
  if (score == Score::kPaper) band_config.band = BandChoice::kAll;
  ColumnMap map = scene.map;
  WallVotes votes({.score = score}, HoughConfig{});
  const HoughSpace& space = votes.update(map, choose_wall_band(map, band_config), Point2::Zero());
  RectangleSearch search(SearchConfig{});
  SearchResult result;
  for (auto _ : state) result = *search.find_best(space, scene.T_zone_base.translation());
  state.counters["planes"] = result.planes_opened;
  state.counters["expansions"] = result.expansions;
}
BENCHMARK(BM_Argmax)
    ->ArgNames({"evidence", "room"})
    ->ArgsProduct({{0, 1}, {0, 1, 2, 3, 4, 5}})
    ->Unit(benchmark::kMillisecond);

/// The whole estimate: votes, argmax, refinement, doors, recent window.
void BM_Estimate(benchmark::State& state) {
  const auto& scene = scenes()[static_cast<std::size_t>(state.range(0))];
  RoomDetector detector({});
  detector.clear(0.05);
  detector.update(scene.change);
  for (const ScanHits& hits : scene.hits) detector.add_hits(hits);
  for (auto _ : state) benchmark::DoNotOptimize(detector.estimate(scene.T_zone_base));
}
BENCHMARK(BM_Estimate)->ArgName("room")->DenseRange(0, 5)->Unit(benchmark::kMillisecond);

/// A changed column, against the paper's step f for a changed cell.
void BM_ChangeColumn(benchmark::State& state) {
  HoughSpace space(HoughConfig{}, Point2::Zero());
  int occupied = 0;
  for (auto _ : state) space.set(0, {Point2(1.23, -2.34), ++occupied % 9, 0, 0});
}
BENCHMARK(BM_ChangeColumn);

}  // namespace
}  // namespace enfilade::room_detector

BENCHMARK_MAIN();
