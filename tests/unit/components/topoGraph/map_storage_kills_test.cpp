// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "components/topoGraph/storage/map_file.hpp"
#include "components/topoGraph/storage/map_store.hpp"
#include "tests/unit/components/topoGraph/forgetful_disk.hpp"
#include "tests/unit/components/topoGraph/random_state.hpp"
#include "tools/evaluate/graph/journal_kills.hpp"

namespace enfilade::topo_graph {
namespace {

using test::ForgetfulDisk;
using test::RandomState;

struct CutResults {
  int lost_changes = 0, damaged = 0, damaged_last = 0;
  int replayed = 0, torn = 0, stale = 0;  ///< what the cuts have left
};

/// The map of a topoGraph on a disk whose power is cut again and again.
class CutMap {
 public:
  CutMap(std::uint64_t seed, bool honest) : random_(seed), honest_(honest) { start_anew(); }

  void live_and_die() {
    disk_.steps_to_live = static_cast<int>(random_() % 60);
    try {
      MapStore store({.file = "map.yaml", .journal_bytes = 1000}, records_, disk_);
      store.begin(changing_.state());
      announced_ = changing_.state();
      for (;;) {
        const TopoState before = changing_.state();
        store.keep(before, changing_.change());
        announced_ = changing_.state();
      }
    } catch (const test::PowerCut&) {
      disk_.cut_power();
    }
  }

  void restart(CutResults& results) {
    try {
      if (const auto last = open("map.yaml.last")) results.replayed += last->replayed > 0;
    } catch (const MapFileError&) {
      ++results.damaged_last;
    }
    try {
      const auto opened = open("map.yaml");
      if (opened) return go_on_with(*opened, results);
      results.lost_changes += announced_.has_value();
    } catch (const MapFileError&) {
      ++results.damaged;
    }
    start_anew();
  }

 private:
  std::optional<OpenedMap> open(const std::string& name) const {
    const auto map = disk_.read(name);
    if (!map) return std::nullopt;
    return open_map(*map, disk_.read(name + ".journal"), name);
  }

  /// What was at work when the power went may be there or not; all before it must be.
  void go_on_with(const OpenedMap& opened, CutResults& results) {
    const TopoState found{opened.file.map, opened.file.session.value()};
    results.lost_changes += announced_ && found != *announced_ && found != changing_.state();
    results.replayed += opened.replayed > 0;
    results.torn += opened.torn.has_value();
    results.stale += disk_.read("map.yaml.journal") && opened.replayed == 0 && opened.file.records > 0;
    if (found.map.rooms.size() > 12) return start_anew();
    records_ = opened.file.records;
    changing_.reset_to(found);
    announced_ = found;
  }

  void start_anew() {
    disk_ = ForgetfulDisk(random_(), honest_);
    changing_ = RandomState(random_());
    records_ = 0;
    announced_.reset();
  }

  std::mt19937_64 random_;
  bool honest_;
  ForgetfulDisk disk_{0, true};
  RandomState changing_{0};
  std::uint64_t records_ = 0;
  std::optional<TopoState> announced_;
};

CutResults cut_power_often(int cuts, bool honest) {
  CutMap map(7, honest);
  CutResults results;
  for (int i = 0; i < cuts; ++i) {
    map.live_and_die();
    map.restart(results);
  }
  return results;
}

TEST(MapStorage, LosesNoAnnouncedChangeWhenThePowerIsCut) {
  const CutResults results = cut_power_often(200, true);
  EXPECT_EQ(results.lost_changes, 0);
  EXPECT_EQ(results.damaged, 0);
  EXPECT_EQ(results.damaged_last, 0);
  EXPECT_GT(results.replayed, 50);  // or the journal was not put to the test
  EXPECT_GT(results.torn, 10);
  EXPECT_GT(results.stale, 10);
}

TEST(MapStorage, WouldLoseChangesOnADiskThatDropsWhatWasNotSynced) {
  const CutResults results = cut_power_often(200, false);
  EXPECT_GT(results.lost_changes, 0);
  EXPECT_GT(results.damaged, 0);
}

TEST(MapStorage, LosesNoAnnouncedRoomWhenTopoGraphIsKilled) {
  const char* full = std::getenv("ENFILADE_FULL");
  const int kills = full && std::string(full) == "1" ? 200 : 20;
  const evaluate::JournalKills result = evaluate::kill_writers(kills, 1);
  EXPECT_EQ(result.kills, kills);
  EXPECT_EQ(result.lost_rooms, 0);
  EXPECT_GT(result.announced_rooms, kills);  // or nothing was put to the test
  EXPECT_GE(result.rooms_at_death, result.announced_rooms);
  EXPECT_GT(result.journals_replayed, kills / 4);
}

}  // namespace
}  // namespace enfilade::topo_graph
