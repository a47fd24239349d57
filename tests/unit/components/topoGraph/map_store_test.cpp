// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_store.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "components/topoGraph/storage/map_file.hpp"
#include "components/topoGraph/storage/map_folder.hpp"
#include "components/topoGraph/storage/map_restore.hpp"
#include "tests/unit/components/topoGraph/random_state.hpp"

namespace enfilade::topo_graph {
namespace {

namespace fs = std::filesystem;

class MapStoreTest : public testing::Test {
 protected:
  MapStoreTest() : folder_(fs::temp_directory_path() / ("map_store_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    store_.begin(random_.state());
  }
  ~MapStoreTest() override { fs::remove_all(folder_); }

  void change(int times = 1) {
    for (int i = 0; i < times; ++i) {
      const TopoState before = random_.state();
      store_.keep(before, random_.change());
    }
  }
  const TopoState& now() const { return random_.state(); }

  static std::string read(const fs::path& path) { return read_if_there(path).value_or(""); }
  static void overwrite(const fs::path& path, std::size_t at, const std::string& text) {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(static_cast<std::streamoff>(at));
    file << text;
  }
  std::string error() const {
    try {
      load_state(path_);
    } catch (const MapFileError& error) {
      return error.what();
    }
    return {};
  }

  fs::path folder_;
  fs::path path_ = folder_ / "map.yaml", journal_ = journal_of(path_), last_ = last_good(path_);
  test::RandomState random_{1};
  MapStore store_{{.file = path_, .journal_bytes = 20000}, 0};
};

TEST_F(MapStoreTest, KeepsEachChangeInTheJournal) {
  const std::string map = read(path_);
  std::string journal = read(journal_);
  for (int i = 0; i < 10; ++i) {
    change();
    ASSERT_EQ(load_state(path_), now());
    ASSERT_TRUE(read(journal_).starts_with(journal));  // it is only added to
    journal = read(journal_);
  }
  EXPECT_EQ(read(path_), map);
  EXPECT_EQ(load_kept(path_).records, 10u);
}

TEST_F(MapStoreTest, FoldsAJournalThatHasGrownLarge) {
  std::uintmax_t largest = 0;
  int folds = 0;
  for (int i = 0; i < 200; ++i) {
    const std::string map = read(path_);
    change();
    folds += read(path_) != map;
    largest = std::max(largest, fs::file_size(journal_));
    if (i % 20 != 0) continue;
    ASSERT_EQ(load_state(path_), now()) << i;
  }
  EXPECT_GE(folds, 2);
  EXPECT_LE(folds, 20);
  EXPECT_LE(largest, std::max<std::uintmax_t>(20000, fs::file_size(path_)) + 200);
}

TEST_F(MapStoreTest, LeavesAllInTheMapFileAtTheEnd) {
  change(5);
  store_.end(now());
  EXPECT_FALSE(fs::exists(journal_));
  EXPECT_EQ(parse_map_file(read(path_), "map.yaml").session, now().session);
  EXPECT_EQ(load_state(last_), now());  // the map before, with the journal that made it the present one
}

TEST_F(MapStoreTest, GoesOnWhereItEnded) {
  change(5);
  store_.end(now());
  store_ = MapStore({path_}, load_kept(path_).records);
  store_.begin(now());
  change(3);
  EXPECT_EQ(load_state(path_), now());
  EXPECT_EQ(load_kept(path_).records, 8u);
}

TEST_F(MapStoreTest, KeepsChangesAlsoWhereTheJournalIsGone) {
  change(3);
  fs::remove(journal_);
  change();
  EXPECT_EQ(load_state(path_), now());
  change();
  EXPECT_EQ(load_state(path_), now());
}

TEST_F(MapStoreTest, IsWholeWhereAToolWroteTheMapMeanwhile) {
  change(3);
  MapFile file = load_map_file(path_);
  file.map.rooms.at(0).name = "kitchen";
  save_map_file(path_, file);
  EXPECT_EQ(load_map_file(path_), file);  // with nothing of the journal that it holds already
  change();
  EXPECT_EQ(load_state(path_), now());
}

TEST_F(MapStoreTest, GivesADamagedMapBackByTheOneBeforeAndItsJournal) {
  change(10);
  store_.begin(now());
  change(10);
  overwrite(path_, read(path_).find("rooms:"), "????");
  EXPECT_TRUE(error().starts_with(path_.string() + ":")) << error();
  EXPECT_NE(error().find("'enfilade map restore " + path_.string() + "' puts it back"), std::string::npos);
  const MapFile restored = restore_last_good(path_);
  EXPECT_EQ((TopoState{restored.map, restored.session.value()}), now());  // both journals were good
  EXPECT_EQ(load_state(path_), now());
  EXPECT_NE(read(path_.string() + ".damaged").find("????"), std::string::npos);
}

TEST_F(MapStoreTest, RefusesAMapThatWasChangedUnderItsJournal) {
  change(10);
  store_.begin(now());
  change(10);
  overwrite(path_, 2, "Spaces");  // in a comment
  EXPECT_NE(error().find("which was changed since"), std::string::npos) << error();
  restore_last_good(path_);
  EXPECT_EQ(load_state(path_), now());
}

TEST_F(MapStoreTest, GivesBackWhatIsGoodOfADamagedJournal) {
  change(4);
  const TopoState good = now();
  const auto at = static_cast<std::size_t>(fs::file_size(journal_));
  change(4);
  overwrite(journal_, at + 50, "????");
  EXPECT_TRUE(error().starts_with(journal_.string() + ":")) << error();
  restore_last_good(path_);
  EXPECT_EQ(load_state(path_), good);
  EXPECT_TRUE(fs::exists(journal_of(path_.string() + ".damaged")));
}

TEST_F(MapStoreTest, GivesAMapWithoutSessionToARobotThatFindsItsPlace) {
  const TopoState made = now();
  save_map_file(path_, {made.map, std::nullopt});
  EXPECT_NE(error().find("locate: true"), std::string::npos) << error();
  const TopoState kept = load_to_locate(path_).state;
  EXPECT_EQ(kept.map, made.map);
  for (const Room& room : made.map.rooms) EXPECT_GE(kept.session.last_room, room.id);
  for (const Door& door : made.map.doors) EXPECT_GE(kept.session.last_door, door.id);
}

TEST_F(MapStoreTest, MovesAMapWithItsJournal) {
  change(4);
  move_map(path_, folder_ / "map.yaml.previous");
  EXPECT_EQ(load_state(folder_ / "map.yaml.previous"), now());
  EXPECT_FALSE(fs::exists(path_) || fs::exists(journal_));
}

}  // namespace
}  // namespace enfilade::topo_graph
