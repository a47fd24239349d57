// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <map>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "components/topoGraph/storage/atomic_file.hpp"
#include "components/topoGraph/storage/map_file.hpp"
#include "tools/evaluate/graph/journal_kills.hpp"

namespace enfilade::topo_graph {
namespace {

struct PowerCut {};

/// A file system that keeps, when the power is cut, any part of what was not synced. `honest` = false: one
/// that says it has synced and has not.
class ForgetfulDisk final : public Disk {
 public:
  ForgetfulDisk(std::uint64_t seed, bool honest) : random_(seed), honest_(honest) {}

  int steps_to_live = 1 << 30;

  void create(const Path& path, std::string_view text) override {
    live();
    if (names_.count(path.string())) throw std::logic_error(path.string() + " exists");
    names_[path.string()] = std::make_shared<File>(File{std::string(text), {}});
  }
  void sync(const Path& path) override {
    live();
    const auto& file = names_.at(path.string());
    if (honest_) file->durable = file->text;
  }
  void rename(const Path& from, const Path& to) override {
    live();
    names_[to.string()] = names_.at(from.string());
    names_.erase(from.string());
  }
  void sync_folder(const Path&) override {
    live();
    if (honest_) durable_ = names_;
  }
  bool link(const Path& file, const Path& name) noexcept override {
    if (steps_to_live < 0 || !names_.count(file.string())) return false;
    names_[name.string()] = names_.at(file.string());
    return true;
  }
  void remove(const Path& path) noexcept override {
    if (steps_to_live >= 0) names_.erase(path.string());
  }

  /// Each name that was not synced is as it was or as it is now; each text that was not is cut off anywhere.
  void cut_power() {
    std::map<std::string, std::shared_ptr<File>> kept;
    for (const auto* names : {&durable_, &names_})
      for (const auto& [name, file] : *names) kept.emplace(name, nullptr);
    for (auto& [name, file] : kept) {
      const auto& from = random_() % 2 ? durable_ : names_;
      const auto found = from.find(name);
      if (found != from.end()) file = found->second;
    }
    std::erase_if(kept, [](const auto& entry) { return !entry.second; });
    names_ = durable_ = kept;
    for (auto& [name, file] : names_) {
      if (file->durable)
        file->text = *file->durable;
      else
        file->text.resize(random_() % (file->text.size() + 1));
      file->durable = file->text;
    }
    steps_to_live = 1 << 30;
  }

  std::optional<std::string> read(const std::string& name) const {
    const auto found = names_.find(name);
    return found == names_.end() ? std::nullopt : std::optional(found->second->text);
  }

 private:
  struct File {
    std::string text;
    std::optional<std::string> durable;
  };

  void live() {
    if (--steps_to_live < 0) throw PowerCut{};
  }

  std::mt19937_64 random_;
  bool honest_;
  std::map<std::string, std::shared_ptr<File>> names_, durable_;
};

TopologicalMap map_of(std::uint64_t rooms) {
  TopologicalMap map{.version = rooms};
  for (std::uint64_t i = 1; i <= rooms; ++i) {
    Room room;
    room.id = room.zone_id = static_cast<std::uint32_t>(i);
    room.width_m = room.height_m = 4.0;
    map.rooms.push_back(room);
  }
  return map;
}

/// Rooms in a file, 0 where there is none; nothing where it is damaged.
std::optional<std::uint64_t> rooms_in(const ForgetfulDisk& disk, const std::string& name) {
  const auto text = disk.read(name);
  if (!text) return 0;
  try {
    return parse_map_file(*text, name).map.rooms.size();
  } catch (const MapFileError&) {
    return std::nullopt;
  }
}

struct Losses {
  int rooms = 0, damaged = 0, damaged_last = 0;
};

/// `cuts` lives of a writer that adds room after room, each ended by a power cut at any step.
Losses cut_power_often(int cuts, bool honest) {
  ForgetfulDisk disk(7, honest);
  std::mt19937_64 random(11);
  Losses losses;
  std::uint64_t announced = 0;
  for (int i = 0; i < cuts; ++i) {
    disk.steps_to_live = static_cast<int>(random() % 20);
    try {
      for (;;) {
        write_atomically("map.yaml", to_yaml({map_of(announced + 1), std::nullopt}), disk);
        ++announced;
      }
    } catch (const PowerCut&) {
      disk.cut_power();
    }
    const auto found = rooms_in(disk, "map.yaml");
    if (!found) ++losses.damaged;
    if (found && *found < announced) ++losses.rooms;
    if (!rooms_in(disk, "map.yaml.last")) ++losses.damaged_last;
    announced = found.value_or(0) > 40 ? 0 : found.value_or(0);
    if (announced == 0) disk = ForgetfulDisk(random(), honest);
  }
  return losses;
}

TEST(MapStorage, LosesNoAnnouncedRoomWhenThePowerIsCut) {
  const Losses losses = cut_power_often(200, true);
  EXPECT_EQ(losses.rooms, 0);
  EXPECT_EQ(losses.damaged, 0);
  EXPECT_EQ(losses.damaged_last, 0);
}

TEST(MapStorage, WouldLoseRoomsOnADiskThatDropsWhatWasNotSynced) {
  const Losses losses = cut_power_often(200, false);
  EXPECT_GT(losses.rooms, 0);
  EXPECT_GT(losses.damaged, 0);
}

TEST(MapStorage, LosesNoAnnouncedRoomWhenTopoGraphIsKilled) {
  const char* full = std::getenv("ENFILADE_FULL");
  const int kills = full && std::string(full) == "1" ? 200 : 20;
  const evaluate::JournalKills result = evaluate::kill_writers(kills, 1);
  EXPECT_EQ(result.kills, kills);
  EXPECT_EQ(result.lost_rooms, 0);
  EXPECT_GT(result.announced_rooms, kills);  // or nothing was put to the test
  EXPECT_GE(result.rooms_at_death, result.announced_rooms);
}

}  // namespace
}  // namespace enfilade::topo_graph
