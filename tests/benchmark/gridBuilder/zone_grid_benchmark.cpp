// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <octomap/OcTree.h>

#include "components/gridBuilder/core/octree.hpp"
#include "tests/unit/components/gridBuilder/box_room.hpp"

/// Inserting a line of 1081 beams at 0.05 m: our grid beside OctoMap's insertPointCloud, in a 6 m room and a
/// 28 × 20 m hall.
namespace enfilade::grid_builder {
namespace {

const Eigen::Vector3d kSensor{0.1037, 0.0211, 0.6013};
constexpr int kLines = 180;

BoxRoom small_room() { return {}; }
BoxRoom hall() { return {{{-14.013, -10.507, 0.004}, {13.998, 9.511, 3.4}}, {}}; }

std::vector<ScanLine> sweep(const BoxRoom& room) {
  std::vector<ScanLine> lines;
  for (int i = 0; i < kLines; ++i) lines.push_back(room.scan(i + 1, kSensor, radians(-90.0 + i)));
  return lines;
}

void ours(benchmark::State& state, const BoxRoom& room) {
  const auto lines = sweep(room);
  ZoneGrid grid({});
  StampNs stamp_ns = 0;
  for (auto _ : state) {
    ScanLine line = lines[stamp_ns % kLines];
    line.stamp_ns = ++stamp_ns;
    benchmark::DoNotOptimize(grid.insert(line));
  }
}

void octomaps(benchmark::State& state, const BoxRoom& room) {
  const ZoneGridConfig config;
  std::vector<octomap::Pointcloud> clouds(kLines);
  const auto lines = sweep(room);
  for (int i = 0; i < kLines; ++i) {
    for (const Point3f& p : lines[i].hits) clouds[i].push_back(p.x_m, p.y_m, p.z_m);
  }
  const auto tree = make_octree(config);
  const Point3f& from = lines[0].origin;
  std::size_t line = 0;
  for (auto _ : state) {
    tree->insertPointCloud(clouds[line++ % kLines], {from.x_m, from.y_m, from.z_m}, config.max_range_m);
  }
}

void snapshot(benchmark::State& state) {
  ZoneGrid grid({});
  for (const ScanLine& line : sweep(small_room())) grid.insert(line);
  for (auto _ : state) benchmark::DoNotOptimize(grid.known_cells());
  state.counters["cells"] = static_cast<double>(grid.known_cells().size());
}

BENCHMARK_CAPTURE(ours, room, small_room())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(octomaps, room, small_room())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(ours, hall, hall())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(octomaps, hall, hall())->Unit(benchmark::kMicrosecond);
BENCHMARK(snapshot)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace enfilade::grid_builder

BENCHMARK_MAIN();
