// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/world/load_world.hpp"

#include <gtest/gtest.h>

#include "interfaces/runtime/config.hpp"
#include "tests/unit/tools/simulator/temporary_file.hpp"

namespace enfilade::simulator {
namespace {

using test::TemporaryFile;

const char* const kGood =
    "name: flat\n"
    "building: {x_m: 1, y_m: 2, yaw_deg: 90}\n"
    "rooms:\n"
    "  - {name: a, width_m: 4, height_m: 3}\n"
    "  - {name: b, x_m: 3.12, width_m: 2, height_m: 3}\n"
    "doors:\n"
    "  - {room: a, wall: east, offset_m: 0.5, width_m: 0.9, to: b}\n"
    "  - {room: a, wall: north, offset_m: -1, width_m: 0.8, to: outside}\n"
    "furniture:\n"
    "  - {room: b, cylinder_m: [0.4, 1.2], x_m: 0.5, y_m: 1}\n"
    "start: {room: a, x_m: -1, yaw_deg: 30}\n";

/// The problems of a world file with this text, each line without the file's name.
std::string problems_of(const std::string& text) {
  const TemporaryFile file("world.yaml", text);
  try {
    load_world(file.path());
  } catch (const ConfigError& e) {
    std::string what = e.what();
    for (std::size_t at; (at = what.find(file.path())) != std::string::npos;)
      what.erase(at, file.path().size() + 1);
    return what;
  }
  return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(LoadWorld, ReadsWhatAPersonWrote) {
  const TemporaryFile file("world.yaml", kGood);
  const World world = load_world(file.path());
  EXPECT_EQ(world.name, "flat");
  ASSERT_EQ(world.truth.rooms.size(), 2u);
  EXPECT_NEAR(world.truth.rooms[1].rectangle.y_m, 2 + 3.12, 1e-9);
  ASSERT_EQ(world.truth.doors.size(), 2u);
  EXPECT_NEAR(world.truth.doors[0].opening.midpoint().x(), 1 - 0.5, 1e-9);
  EXPECT_NEAR(world.truth.doors[0].opening.midpoint().y(), 2 + 2.06, 1e-9);
  EXPECT_NEAR(world.truth.doors[1].opening.midpoint().x(), 1 - 1.56, 1e-9);
  EXPECT_NEAR(world.truth.doors[1].opening.midpoint().y(), 2 - 1, 1e-9);
  EXPECT_FALSE(world.truth.doors[1].other);
  EXPECT_NEAR(world.truth.T_world_start.yaw_rad, radians(120), 1e-9);
}

TEST(LoadWorld, NamesTheLineOfEveryProblemAtOnce) {
  std::string text = replaced(kGood, "width_m: 4, ", "width_m: wide, ");
  text = replaced(text, "wall: east", "wall: left");
  text = replaced(text, "yaw_deg: 30", "yaw_deg: 30, colour: red");
  const std::string what = problems_of(text);
  EXPECT_NE(what.find("4: rooms: 'width_m' must be a number"), std::string::npos) << what;
  EXPECT_NE(what.find("7: doors: 'wall' must be east"), std::string::npos) << what;
  EXPECT_NE(what.find("11: start: 'colour' is not known: use one of"), std::string::npos) << what;
}

TEST(LoadWorld, RefusesAWorldWithoutRooms) {
  EXPECT_NE(problems_of("rooms: []\nstart: {x_m: 0}\n").find("a world needs at least one room"),
            std::string::npos);
  EXPECT_NE(problems_of("name: nothing\n").find("neither 'rooms'"), std::string::npos);
  for (const char* const text : {"", "hello\n", "- 1\n"})
    EXPECT_NE(problems_of(text).find("1: is no world: write a map of 'key: value'"), std::string::npos)
        << text;
}

TEST(LoadWorld, SaysWhatElseCanBeWrong) {
  const auto expect = [](const std::string& from, const std::string& to, const std::string& sentence) {
    const std::string what = problems_of(replaced(kGood, from, to));
    EXPECT_NE(what.find(sentence), std::string::npos) << what;
  };
  expect("to: b}", "to: c}", "7: doors: there is no room 'c': name one from the list 'rooms'");
  expect("to: b}", "to: outside}", "7: this door leads into 'b': write to: b");
  expect("x_m: 3.12", "x_m: 3.00", "5: a wall of 'b' stands inside 'a'");
  expect("offset_m: 0.5", "offset_m: 1.4", "7: the opening reaches beyond the end of this wall");
  expect("name: b", "name: a", "5: rooms: a room 'a' exists already: choose another name");
  expect("height_m: 3}", "height_m: 300}", "4: rooms: 'height_m' is 300: it must lie between 0.5 and 80");
  expect("name: flat", "name: flat\nname: house", "2: 'name' stands here twice: keep one");
  expect("cylinder_m: [0.4, 1.2]", "cylinder_m: [0.4]",
         "10: furniture: 'cylinder_m' must be a list of 2 numbers");
  expect("start: {room: a, x_m: -1, yaw_deg: 30}\n", "", "'start' is missing");
  expect("rooms:", "rooms: [", "not YAML");
}

TEST(LoadWorld, SaysThatAFileCannotBeRead) { EXPECT_THROW(load_world("/nowhere/world.yaml"), ConfigError); }

}  // namespace
}  // namespace enfilade::simulator
