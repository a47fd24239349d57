// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>
#include <octomap/OcTree.h>

#include "components/gridBuilder/core/octree.hpp"
#include "components/gridBuilder/core/zone_pictures.hpp"
#include "tests/benchmark/perception/timing.hpp"
#include "tests/unit/components/gridBuilder/box_room.hpp"

/// What rt/octomap and rt/local_map cost once a second in the 28 × 20 × 6 m hall, while 40 lines a second
/// come in: the slices between which lines are fused, and the bytes put together at the end. OctoMap's way
/// beside it: a tree of the whole grid.
namespace enfilade::bench {
namespace {

using grid_builder::BoxRoom;
using grid_builder::ScanLine;
using grid_builder::ZoneGrid;
using grid_builder::ZonePictures;

constexpr int kLinesOfSweep = 120, kLinesOfSecond = 40;
constexpr std::size_t kSlice = 128;

ScanLine line_of_hall(int i) {
  static const BoxRoom hall{{{-14.013, -10.507, 0.004}, {13.998, 9.511, 6.003}}, {}};
  const double roll = radians(-90.0 + 180.0 / kLinesOfSweep * (i % kLinesOfSweep));
  return hall.scan(i + 1, {0.1037, 0.0211, 0.6013}, roll);
}

enum class Part { kSlices, kBytes };

void pictures_of_hall(benchmark::State& state, Part part) {
  InputTimes slices, bytes;
  std::size_t size = 0;
  for (auto _ : state) {
    ZoneGrid grid({.max_range_m = 30.0, .max_height_m = 6.5});
    ZonePictures pictures({});
    pictures.follow(grid);
    std::size_t slice = 0, second = 0;
    for (int i = 0; i < 2 * kLinesOfSweep; ++i) {
      pictures.note(grid.insert(line_of_hall(i)).changes);
      if ((i + 1) % kLinesOfSecond != 0) continue;
      for (bool more = true; more;) slices.measure(slice++, [&] { more = pictures.draw(grid, kSlice); });
      bytes.measure(second++, [&] {
        size = pictures.octree().size();
        benchmark::DoNotOptimize(pictures.floor(0.05, Point2::Zero()));
      });
    }
  }
  (part == Part::kSlices ? slices : bytes).report(state);
  state.counters["octomap_kB"] = static_cast<double>(size) / 1000.0;
}

void tree_of_hall(benchmark::State& state) {
  ZoneGrid grid({.max_range_m = 30.0, .max_height_m = 6.5});
  for (int i = 0; i < kLinesOfSweep; ++i) grid.insert(line_of_hall(i));
  for (auto _ : state) benchmark::DoNotOptimize(grid_builder::to_octree(grid));
}

const bool kPicturesAdded = [] {
  const auto add = [](const char* name, auto work, auto... more) {
    benchmark::RegisterBenchmark(name, work, more...)->Unit(benchmark::kMillisecond);
  };
  add("Pictures/slice", pictures_of_hall, Part::kSlices);
  add("Pictures/bytes", pictures_of_hall, Part::kBytes);
  add("Pictures/octree", tree_of_hall);
  return true;
}();

}  // namespace
}  // namespace enfilade::bench
