// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/rectangle_search.hpp"
#include "tests/benchmark/perception/crew_runner.hpp"
#include "tests/benchmark/perception/random_scans.hpp"
#include "tests/benchmark/perception/timing.hpp"

/// One scan line after the other, as gridBuilder reports them: votes brought up to date, argmax found anew
/// with the budget that is deployed. `gaps` counts the answers that were not proven by then.
namespace enfilade::bench {
namespace {

using namespace room_detector;

struct Stream {
  struct Line {
    GridChange change;
    Point2 robot;
  };
  std::vector<Line> lines;
};

std::vector<Stream> streams() {
  std::vector<Stream> streams(4);
  for (unsigned seed = 0; seed < streams.size(); ++seed) {
    RoomScans scans(seed + 100);
    for (int i = 0; i < 3 * RoomScans::kLines; ++i) {
      const Point2 robot = scans.T_zone_base().translation();
      streams[seed].lines.push_back({scans.next_line(), robot});
    }
  }
  return streams;
}

void streaming(benchmark::State& state, const TaskRunner& runner) {
  static const std::vector<Stream> all = streams();
  InputTimes times(runner.workers > 1 ? wall_ms : thread_ms);
  double gaps = 0.0;
  for (auto _ : state) {
    gaps = 0.0;
    std::size_t input = 0;
    for (const Stream& stream : all) {
      ColumnMap map;
      map.clear(0.05);
      WallVotes votes({}, {});
      RectangleSearch search({}, {}, runner);
      const Point2& first = stream.lines.front().robot;
      const Point2 origin(std::round(first.x()), std::round(first.y()));
      for (const Stream::Line& line : stream.lines) {
        times.measure(input++, [&] {
          map.apply(line.change.cells);
          const HoughSpace& space = votes.update(map, choose_wall_band(map, {}), origin, line.robot);
          const auto found = search.find_best(space, line.robot);
          gaps += found && found->gap > 0;
        });
      }
    }
  }
  times.report(state);
  state.counters["gaps"] = gaps;
}

const bool kRegistered = [] {
  const auto add = [](const char* name, auto run) {
    benchmark::RegisterBenchmark(name, run)->Unit(benchmark::kMillisecond);
  };
  add("LineUpdate/streaming", [](benchmark::State& s) { streaming(s, deployed_runner()); });
  add("LineUpdate/streaming_one_thread", [](benchmark::State& s) { streaming(s, {}); });
  return true;
}();

}  // namespace
}  // namespace enfilade::bench
