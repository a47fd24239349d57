// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/graph/journal_kills.hpp"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

#include "components/topoGraph/node/topo_graph_node.hpp"
#include "components/topoGraph/storage/map_file.hpp"
#include "interfaces/runtime/composed_system.hpp"
#include "tools/support/scratch_folder.hpp"

namespace enfilade::evaluate {
namespace {

namespace fs = std::filesystem;
using topo_graph::TopoGraphConfig;
using topo_graph::TopoGraphNode;

constexpr RoomId kReady = 0;  ///< told in place of a room: the map has been read
constexpr int kRoomsOfABuilding = 30;
constexpr double kSideM = 4.0, kPitchM = 4.15;

/// Zone k of a straight row of rooms, a door to the next one in wall 0 and to the one before in wall 2.
RoomEstimate room_of_zone(std::uint32_t zone) {
  RoomEstimate estimate;
  estimate.tag = {.zone_id = zone, .grid_epoch = zone, .odom_boot = 1};
  estimate.stamp_ns = from_seconds(zone);
  estimate.found = true;
  estimate.rectangle = {0.0, kPitchM * (zone - 1), 0.0, kSideM, kSideM};
  estimate.doors = {{.gap = {0, 1.0, 2.0}, .state = DoorState::kOpen}};
  if (zone > 1) estimate.doors.push_back({.gap = {2, 2.0, 3.0}, .state = DoorState::kOpen});
  return estimate;
}

/// A topoGraph that goes on with the map it has, and an explorer that hands it one room after another. Writes
/// the id of each room that was announced into `announced`, until it is killed.
class DoomedWriter {
 public:
  DoomedWriter(const fs::path& map_file, int announced) : announced_(announced) {
    TopoGraphConfig config;
    config.map_file = map_file;
    config.resume = true;
    config.journal_kib = 1;  // is folded often, so that deaths fall into that too
    system_.add("topoGraph", config.period, [config](const NodeContext& context) {
      return std::make_unique<TopoGraphNode>(context, config);
    });
    Bus& bus = system_.tool_bus();
    bus.subscribe<TopologicalMap>(topics::kTopologicalMap, [this](const TopologicalMap& map) { hear(map); });
    bus.subscribe<CurrentZone>(topics::kCurrentZone, [this](const CurrentZone& zone) { zone_ = zone; });
  }

  void write_until_killed() {
    Bus& explorer = system_.bus_as("explorer");
    const auto fix = explorer.advertise(topics::kFixRoom.request);
    const auto enter = explorer.advertise(topics::kEnterZone.request);
    system_.initialize();
    tell(kReady);
    for (std::uint64_t number = 1;; ++number) {
      system_.run_until({}, system_.clock().now_ns() + from_seconds(0.2));
      const CallId call{"explorer " + std::to_string(::getpid()), number};
      const std::uint32_t zone = zone_.zone_id;
      if (!zone_.room) {
        fix.publish({call, room_of_zone(zone)});
      } else if (const auto door = way_on(*zone_.room)) {
        enter.publish({call, *zone_.room, *door, {kPitchM * (zone - 1) + 2.5, -0.5, 0.0}, 0});
      } else {
        throw std::logic_error("the row of rooms ends at room " + std::to_string(*zone_.room));
      }
    }
  }

 private:
  void hear(const TopologicalMap& map) {
    map_ = map;
    for (const Room& room : map.rooms)
      if (told_.insert(room.id).second) tell(room.id);
  }

  void tell(RoomId id) const {
    if (::write(announced_, &id, sizeof id) < 0)
      throw std::system_error(errno, std::generic_category(), "cannot tell that a room was announced");
  }

  std::optional<DoorId> way_on(RoomId room) const {
    for (const Door& door : map_.doors)
      if (door.kind == DoorKind::kUnresolved && door.face.room == room) return door.id;
    return std::nullopt;
  }

  int announced_;
  ComposedSystem system_;
  TopologicalMap map_;
  CurrentZone zone_;
  std::set<RoomId> told_;
};

struct Pipe {
  Pipe() {
    if (::pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "cannot make a pipe");
  }
  ~Pipe() {
    for (const int end : ends)
      if (end >= 0) ::close(end);
  }
  void close(int which) { ::close(std::exchange(ends[which], -1)); }

  int ends[2] = {-1, -1};
};

[[noreturn]] void be_the_writer(const fs::path& map_file, int announced) {
  try {
    DoomedWriter(map_file, announced).write_until_killed();
  } catch (const std::exception& error) {
    const std::string line = std::string("topoGraph: ") + error.what() + "\n";
    if (::write(STDERR_FILENO, line.data(), line.size()) < 0) ::_exit(4);
  }
  ::_exit(3);
}

struct Life {
  std::chrono::microseconds length;
  bool from_ready;  ///< counted from when it has read its map; else from its birth
};

/// The rooms that a writer has announced in its life.
std::set<RoomId> live_and_die(const fs::path& map_file, const Life& life) {
  Pipe pipe;
  const pid_t pid = ::fork();
  if (pid < 0) throw std::system_error(errno, std::generic_category(), "cannot start a writer");
  if (pid == 0) be_the_writer(map_file, pipe.ends[1]);
  pipe.close(1);
  std::set<RoomId> announced;
  const auto hear_one = [&](RoomId& id) {
    if (::read(pipe.ends[0], &id, sizeof id) != sizeof id) return false;
    if (id != kReady) announced.insert(id);
    return true;
  };
  RoomId id = kReady + 1;
  while (life.from_ready && id != kReady && hear_one(id)) continue;
  std::this_thread::sleep_for(life.length);
  ::kill(pid, SIGKILL);
  int status = 0;
  ::waitpid(pid, &status, 0);
  if (!WIFSIGNALED(status)) throw std::runtime_error("the writer ended before it was killed");
  while (hear_one(id)) continue;
  return announced;
}

}  // namespace

JournalKills kill_writers(int kills, std::uint64_t seed) {
  const ScratchFolder folder;
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> life_us(0, 60000);
  JournalKills result;
  fs::path map_file;
  std::size_t rooms = kRoomsOfABuilding;
  for (; result.kills < kills; ++result.kills) {
    if (rooms >= kRoomsOfABuilding) map_file = folder.path() / std::to_string(result.kills) / "map.yaml";
    const std::set<RoomId> announced =
        live_and_die(map_file, {std::chrono::microseconds(life_us(random)), result.kills % 4 != 0});
    const topo_graph::OpenedMap opened =
        fs::exists(map_file) ? topo_graph::open_map(map_file) : topo_graph::OpenedMap{};
    const TopologicalMap& map = opened.file.map;
    result.journals_replayed += opened.replayed > 0;
    for (const RoomId id : announced) result.lost_rooms += map.find_room(id) == nullptr;
    result.announced_rooms += static_cast<int>(announced.size());
    result.rooms_at_death += static_cast<int>(map.rooms.size());
    rooms = map.rooms.size();
  }
  return result;
}

}  // namespace enfilade::evaluate
