// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <octomap/OcTree.h>

#include "components/gridBuilder/core/octree.hpp"
#include "tests/benchmark/perception/timing.hpp"
#include "tests/unit/components/gridBuilder/box_room.hpp"

/// Fusing a line of 1081 beams at 0.05 m into a grid: ours beside OctoMap's insertPointCloud, with the same
/// sensor model. Two sweeps from an empty grid: the first explores, the second sees everything again.
namespace enfilade::bench {
namespace {

using grid_builder::BoxRoom;
using grid_builder::ScanLine;
using grid_builder::ZoneGrid;
using grid_builder::ZoneGridConfig;

constexpr int kLinesOfSweep = 120, kSweeps = 2;
const ZoneGridConfig kFarSight{.max_range_m = 30.0, .max_height_m = 6.5};

BoxRoom room() { return {{{-3.013, -3.007, 0.004}, {2.998, 2.991, 2.597}}, {}}; }
BoxRoom hall() { return {{{-14.013, -10.507, 0.004}, {13.998, 9.511, 6.003}}, {}}; }

std::vector<ScanLine> sweeps(const BoxRoom& walls) {
  const Eigen::Vector3d sensor{0.1037, 0.0211, 0.6013};
  std::vector<ScanLine> lines;
  for (int i = 0; i < kSweeps * kLinesOfSweep; ++i) {
    const double roll = radians(-90.0 + 180.0 / kLinesOfSweep * (i % kLinesOfSweep));
    lines.push_back(walls.scan(i + 1, sensor, roll));
  }
  return lines;
}

void enfilade_grid(benchmark::State& state, const BoxRoom& walls) {
  const auto lines = sweeps(walls);
  InputTimes times;
  for (auto _ : state) {
    ZoneGrid grid(kFarSight);
    for (std::size_t i = 0; i < lines.size(); ++i)
      times.measure(i, [&] { benchmark::DoNotOptimize(grid.insert(lines[i])); });
  }
  times.report(state);
}

void octomap_grid(benchmark::State& state, const BoxRoom& walls) {
  const auto lines = sweeps(walls);
  InputTimes times;
  for (auto _ : state) {
    const auto tree = grid_builder::make_octree(kFarSight);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      octomap::Pointcloud cloud;
      for (const Point3f& p : lines[i].hits) cloud.push_back(p.x_m, p.y_m, p.z_m);
      const Point3f& from = lines[i].origin;
      times.measure(i, [&] {
        tree->insertPointCloud(cloud, {from.x_m, from.y_m, from.z_m}, kFarSight.max_range_m);
      });
    }
  }
  times.report(state);
}

void add(const std::string& name, void (*work)(benchmark::State&, const BoxRoom&), const BoxRoom& walls) {
  benchmark::RegisterBenchmark(name.c_str(), work, walls)->Unit(benchmark::kMillisecond);
}

const bool kAdded = [] {
  add("GridHall/enfilade", enfilade_grid, hall());
  add("GridHall/octomap", octomap_grid, hall());
  add("GridRoom/enfilade", enfilade_grid, room());
  add("GridRoom/octomap", octomap_grid, room());
  return true;
}();

}  // namespace
}  // namespace enfilade::bench
