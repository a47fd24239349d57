// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "components/roomDetector/core/room_detector.hpp"
#include "tests/unit/components/roomDetector/random_rooms.hpp"
#include "tests/unit/components/roomDetector/sim_grid.hpp"

namespace enfilade::room_detector {
namespace {

/// Furnished rooms after two sweeps, made once.
struct Scene {
  std::vector<ScanHits> hits;
  GridChange change;
  Pose2 T_zone_base;
};

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = [] {
    std::vector<Scene> made;
    for (unsigned seed = 0; seed < 3; ++seed) {
      const test::SimRoom room = test::RandomRooms(seed).next();
      test::SimGrid grid(0.05, seed);
      Scene scene;
      for (const double yaw : {0.3, 0.3 + 0.5 * kPi}) {
        scene.T_zone_base = room.T_zone_room * Pose2{0.0, 0.0, yaw};
        const auto lines = grid.sweep(room, scene.T_zone_base);
        scene.hits.insert(scene.hits.end(), lines.begin(), lines.end());
      }
      scene.change = grid.changes();
      made.push_back(std::move(scene));
    }
    return made;
  }();
  return all;
}

/// The whole estimate: votes, argmax, refinement, doors, recent window.
void estimate(benchmark::State& state) {
  const auto& scene = scenes()[static_cast<std::size_t>(state.range(0))];
  RoomDetector detector({});
  detector.clear(0.05);
  detector.update(scene.change);
  for (const ScanHits& hits : scene.hits) detector.add_hits(hits);
  for (auto _ : state) benchmark::DoNotOptimize(detector.estimate(scene.T_zone_base));
}
BENCHMARK(estimate)->Name("Estimate")->ArgName("room")->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace enfilade::room_detector
