// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_file.hpp"

#include <algorithm>
#include <cctype>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "components/topoGraph/storage/atomic_file.hpp"
#include "components/topoGraph/storage/map_restore.hpp"
#include "components/topoGraph/storage/map_store.hpp"
#include "tests/unit/components/topoGraph/rooms.hpp"

namespace enfilade::topo_graph {
namespace {

namespace fs = std::filesystem;
using namespace test;

/// A file with everything in it that a file can hold, and numbers that are hard to print.
MapFile rich_file() {
  TopoGraph graph = graph_in_zone2({}, {door_from_room1(), second_from_room1()});
  fix_room2(graph, {1.0 / 3.0, 0.05, 1e-3}, {door_from_room2(), open_door(0, 1.0, 2.0)});
  graph.mark_door({{"name: \"odd\\\n é\t#", 7}, 2, DoorKind::kExit}, 3);
  graph.mark_door({{"", std::numeric_limits<std::uint64_t>::max()}, 99, DoorKind::kExit}, 3);
  graph.mark_door({{"", 8}, 1, DoorKind::kUnresolved, true}, 3);
  TopoState state = graph.state();
  state.map.rooms[0].covariance.emplace();
  for (std::size_t i = 0; i < 25; ++i)
    (*state.map.rooms[0].covariance)[i] = 1e-5 / (1.0 + static_cast<double>(i));
  state.map.rooms[0].polygon = {{-1.6, -1.9}, {1.6, -1.9}, {-0.0, 1e-300}};
  state.map.rooms[1].name = "Küche: 'α'";
  state.map.doors[0].height_m = 2.0000000000000004;
  state.map.rooms[1].measured_size_m = Point2(4.2, 3.8);
  state.map.doors[0].other_face->measured_offset_m = -0.25;
  state.map.doors[0].measured_thickness_m = 0.11;
  state.map.doors[0].other_face->position_sigma_m = 0.3;
  LoopClosure closure{.door = 1, .room = 1, .instead = state.map.rooms[1], .link = state.map.links.at(0)};
  closure.instead.id = closure.link.to = 0;
  closure.entrance = {2, 0.1, 0.9};
  closure.gaps = {{0, 1.0, 2.0}, {1, 0.5, 1.5}};
  closure.added = {2, 3};
  state.session.closures = {closure, closure};
  state.session.zone.located = false;
  return {state.map, state.session};
}

std::string error_of(const std::string& text) {
  try {
    parse_map_file(text, "map.yaml");
  } catch (const MapFileError& error) {
    return error.what();
  }
  return {};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

int line_of(const std::string& text, const std::string& part) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(text.find(part));
  return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

class MapFileOnDisk : public testing::Test {
 protected:
  MapFileOnDisk() : folder_(fs::temp_directory_path() / ("topo_map_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~MapFileOnDisk() override { fs::remove_all(folder_); }

  fs::path folder_;
};

TEST(MapFile, ReadsBackWhatItWrote) {
  const MapFile file = rich_file();
  EXPECT_EQ(parse_map_file(to_yaml(file), "map.yaml"), file);
  const MapFile map_only{file.map, std::nullopt};
  EXPECT_EQ(parse_map_file(to_yaml(map_only), "map.yaml"), map_only);
  const TopoState first = first_state(5);
  EXPECT_EQ(parse_map_file(to_yaml({first.map, first.session}), "x").session, first.session);
}

TEST(MapFile, CutOffAnywhereIsRefusedWithALine) {
  const std::string text = to_yaml(rich_file());
  for (std::size_t length = 0; length < text.size(); ++length) {
    const std::string error = error_of(text.substr(0, length));
    ASSERT_EQ(error.rfind("map.yaml:", 0), 0u) << length << ": " << error;
    ASSERT_TRUE(std::isdigit(static_cast<unsigned char>(error[9]))) << error;
  }
}

TEST(MapFile, NamesTheLineAndWhatIsWrong) {
  const std::string good = to_yaml(rich_file());
  const auto expect_error = [&](const std::string& from, const std::string& to, const std::string& what) {
    const std::string error = error_of(replaced(good, from, to));
    EXPECT_EQ(error.rfind("map.yaml:" + std::to_string(line_of(good, from)) + ": ", 0), 0u) << error;
    EXPECT_NE(error.find(what), std::string::npos) << error;
  };
  expect_error("version: 2", "version: 3", "versions 1 to 2");
  expect_error("format: enfilade-map", "format: other", "is not enfilade-map");
  expect_error("width_m: 3.2", "width_m: nan", "finite");
  expect_error("width_m: 3.2", "width_m: -3.2", "greater than 0");
  expect_error("    fixed_ns: ", "    colour: red\n    fixed_ns: ", "colour: is not a key");
  expect_error("kind: passage", "kind: hole", "hole");
  expect_error("room: 1, wall: 0", "room: 9, wall: 0", "no room 9");
  expect_error("room: 1, wall: 0", "room: 1, wall: 4", "0 to 3");
  expect_error("to_m: 2.9", "to_m: 29", "does not lie on its wall");
  expect_error("yaw_rad: 0}", "yaw_rad: 0, yaw_rad: 0}", "twice");
  expect_error("  - id: 2", "  - id: 1", "grow");
  expect_error("last_room: 2", "last_room: 1", "in use");
  expect_error("accepted: true", "accepted: yes", "true or false");
  EXPECT_NE(error_of(replaced(good, "    width_m: 3.2\n", "")).find("width_m is missing"), std::string::npos);
  EXPECT_EQ(error_of(replaced(good, "stamp_ns: 3", "stamp_ns: [3")).rfind("map.yaml:7: ", 0), 0u);
}

TEST(MapFile, WithMoreThanOneDocumentIsRefused) {
  const std::string good = to_yaml(rich_file());
  EXPECT_NE(error_of(good + "---\nsomething: else\nend: enfilade-map\n").find("last line"),
            std::string::npos);
}

TEST(MapFile, SurvivesAnyChangedByte) {
  const std::string good = to_yaml(rich_file());
  const std::string odd(
      "\0{\"&*-\xff"
      "9",
      8);
  for (std::size_t at = 0; at < good.size(); at += 7) {
    std::string bad = good;
    bad[at] = odd[at % odd.size()];
    error_of(bad);  // refused or read, never a crash or another exception
  }
  EXPECT_FALSE(error_of(std::string(100000, '[') + "\nend: enfilade-map\n").empty());
}

TEST_F(MapFileOnDisk, IsKeptForToolsAndForTheNode) {
  const fs::path path = folder_ / "new" / "map.yaml";
  const MapFile file = rich_file();
  save_map(path, file.map);
  EXPECT_EQ(load_map(path), file.map);
  EXPECT_THROW(load_state(path), MapFileError);  // no session in it
  save_state(path, {file.map, *file.session});
  EXPECT_EQ(load_state(path), (TopoState{file.map, *file.session}));
  EXPECT_EQ(load_map(path), file.map);
  EXPECT_THROW(load_map(folder_ / "none.yaml"), MapFileError);
}

TEST_F(MapFileOnDisk, OffersTheLastGoodCopyOfADamagedFile) {
  const fs::path path = folder_ / "map.yaml";
  const MapFile file = rich_file();
  save_map_file(path, file);
  const auto told = [&path] {
    try {
      load_map_file(path);
    } catch (const MapFileError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  std::ofstream(path) << replaced(to_yaml(file), "width_m: 3.2", "width_m: nan");
  EXPECT_NE(told().find("finite"), std::string::npos);
  EXPECT_EQ(told().find("last good"), std::string::npos) << told();  // there is none yet
  save_map_file(path, file);
  save_map_file(path, file);
  std::ofstream(path) << to_yaml(file).substr(0, 100);
  EXPECT_EQ(told().rfind(path.string() + ":2: ", 0), 0u) << told();
  EXPECT_NE(told().find("(the last good map has 2 rooms: 'enfilade map restore " + path.string() + "'"),
            std::string::npos)
      << told();
  EXPECT_EQ(restore_last_good(path), file);
  EXPECT_EQ(load_map_file(path), file);
  EXPECT_EQ(read(path.string() + ".damaged"), to_yaml(file).substr(0, 100));
  EXPECT_THROW(restore_last_good(path), MapFileError);  // what is good is left as it is
}

TEST_F(MapFileOnDisk, KeepsTheOldFileWhenAWriteFails) {
  const fs::path path = folder_ / "map.yaml";
  write_atomically(path, "old", folder_ / "kept");
  fs::create_directory(folder_ / "map.yaml.tmp");
  EXPECT_THROW(write_atomically(path, "new", folder_ / "kept"), std::system_error);
  EXPECT_EQ(read(path), "old");
}

TEST_F(MapFileOnDisk, KeepsTheOldFileWhenTheDiskIsFull) {
  const fs::path path = folder_ / "map.yaml";
  write_atomically(path, "old", folder_ / "kept");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{4096, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(write_atomically(path, std::string(100000, 'x'), folder_ / "kept"), std::system_error);
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(read(path), "old");
  EXPECT_FALSE(fs::exists(folder_ / "map.yaml.tmp"));
}

}  // namespace
}  // namespace enfilade::topo_graph
