// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "components/topoGraph/storage/map_file.hpp"
#include "components/topoGraph/storage/map_folder.hpp"
#include "components/topoGraph/storage/map_store.hpp"
#include "tools/support/scratch_folder.hpp"

/// What it costs to keep one accepted change: time of the processor and bytes written, with and without the
/// journal.
namespace enfilade::topo_graph {
namespace {

/// The operating system's, with a count.
class CountingDisk final : public Disk {
 public:
  std::size_t bytes = 0;

  void create(const Path& path, std::string_view text) override {
    bytes += text.size();
    real_disk().create(path, text);
  }
  void append(const Path& path, std::string_view text) override {
    bytes += text.size();
    real_disk().append(path, text);
  }
  void sync(const Path& path) override { real_disk().sync(path); }
  void rename(const Path& from, const Path& to) override { real_disk().rename(from, to); }
  void sync_folder(const Path& folder) override { real_disk().sync_folder(folder); }
  bool exists(const Path& path) const noexcept override { return real_disk().exists(path); }
  bool link(const Path& file, const Path& name) noexcept override { return real_disk().link(file, name); }
  void remove(const Path& path) noexcept override { real_disk().remove(path); }
};

/// A row of rooms with all that a room and its doors carry after an exploration.
TopoState row_of_rooms(RoomId rooms) {
  TopoState state = first_state(0);
  for (RoomId id = 1; id <= rooms; ++id) {
    Room room{.id = id, .name = "room " + std::to_string(id), .T_map_room = {4.15 * id, 1.0 / id, 1e-3 / id}};
    room.width_m = room.height_m = 4.0 + 0.01 / id;
    room.measured_size_m = Point2(4.0, 4.0);
    room.covariance.emplace().fill(1e-5 / 3.0);
    room.zone_id = id;
    room.place = 2;
    state.map.rooms.push_back(room);
    Door door{.id = id, .face = {id, {0, 1.0, 1.9 + 0.01 / id}, 0.01}};
    if (id < rooms) door.other_face = {id + 1, {2, 2.1 - 0.01 / id, 3.0}, 0.01};
    if (id < rooms) door.kind = DoorKind::kPassage;
    state.map.doors.push_back(door);
    if (id > 1) state.map.links.push_back({id - 1, id, {4.15, 0.001 * id, 1e-3}, 0.05, 0.02});
    const CallId call{"explorer 1234", id};
    remember(state.session, {call, RequestKind::kFixRoom, true, "", id}, 64);
  }
  state.session.last_room = state.session.last_door = state.session.zone.zone_id = rooms;
  state.session.zone.room = rooms;
  return state;
}

void report(benchmark::State& state, const CountingDisk& disk) {
  const double changes = static_cast<double>(state.iterations());
  state.counters["bytes_per_change"] = static_cast<double>(disk.bytes) / changes;
}

/// One room more, in the journal; what folding it into the map file costs is included.
void keep_in_journal(benchmark::State& state) {
  const ScratchFolder folder;
  const auto rooms = static_cast<RoomId>(state.range(0));
  const TopoState before = row_of_rooms(rooms), after = row_of_rooms(rooms + 1);
  CountingDisk disk;
  MapStore store({.file = folder.path() / "map.yaml"}, 0, disk);
  store.begin(before);
  disk.bytes = 0;
  for (auto _ : state) store.keep(before, after);
  report(state, disk);
}

/// One room more, in a map file that is written as a whole.
void write_whole_map(benchmark::State& state) {
  const ScratchFolder folder;
  const TopoState after = row_of_rooms(static_cast<RoomId>(state.range(0)) + 1);
  CountingDisk disk;
  for (auto _ : state) write_map_file(folder.path() / "map.yaml", to_yaml({after.map, after.session}), disk);
  report(state, disk);
}

/// What a restart has to read.
void open_map_file(benchmark::State& state) {
  const TopoState rooms = row_of_rooms(static_cast<RoomId>(state.range(0)));
  const std::string text = to_yaml({rooms.map, rooms.session});
  for (auto _ : state) benchmark::DoNotOptimize(open_map(text, std::nullopt, "map.yaml"));
}

constexpr auto in_milliseconds = benchmark::kMillisecond;
BENCHMARK(keep_in_journal)
    ->Name("KeepChange/journal")
    ->Arg(100)
    ->Arg(1000)
    ->Arg(10000)
    ->Unit(in_milliseconds);
BENCHMARK(write_whole_map)->Name("KeepChange/whole")->Arg(100)->Arg(1000)->Arg(10000)->Unit(in_milliseconds);
BENCHMARK(open_map_file)->Name("OpenMap")->Arg(100)->Arg(1000)->Arg(10000)->Unit(in_milliseconds);

}  // namespace
}  // namespace enfilade::topo_graph
