// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <png.h>

#include "interfaces/runtime/config.hpp"
#include "tests/unit/tools/simulator/temporary_file.hpp"
#include "tests/unit/tools/simulator/test_worlds.hpp"
#include "tools/simulator/core/occupancy.hpp"
#include "tools/simulator/world/load_world.hpp"

namespace enfilade::simulator {
namespace {

using test::range_along;
using test::TemporaryFile;

// # occupied, . free, ? unknown; one cell is 0.5 m, the lower left corner lies at (-1, 2).
const std::vector<std::string> kPicture = {
    "########",  //
    "#......#",  //
    "#..##..#",  //
    "#..##..?",  //
    "#......#",  //
    "########",
};
const char* const kMap =
    "image: map.pgm\nresolution: 0.5\norigin: [-1.0, 2.0, 0.0]\nnegate: 0\noccupied_thresh: "
    "0.65\nfree_thresh: 0.196\n";

std::string pixels() {
  std::string bytes;
  for (const std::string& row : kPicture)
    for (const char c : row) bytes += static_cast<char>(c == '#' ? 0 : c == '.' ? 254 : 205);
  return bytes;
}

std::string pgm() { return "P5\n# made by hand\n8 6\n255\n" + pixels(); }

bool occupied_at(const World& world, const Point2& p) {
  for (const Solid& solid : world.solids)
    if (in_the_way(solid, 0.7) && distance(p, solid.base) == 0.0) return true;
  return false;
}

TEST(MapServer, EveryOccupiedPixelAndNoOtherBecomesAWallInItsPlace) {
  const TemporaryFile file("map.yaml", kMap);
  file.add("map.pgm", pgm());
  const World world = load_world(file.path());
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 8; ++column) {
      const Point2 centre(-1.0 + 0.5 * (column + 0.5), 2.0 + 0.5 * (6 - row - 0.5));
      EXPECT_EQ(occupied_at(world, centre), kPicture[row][column] == '#') << row << " " << column;
    }
  EXPECT_TRUE(world.truth.rooms.empty());
  EXPECT_LT(world.solids.size(), 12u);  // cells are joined
}

TEST(MapServer, TheLaserSeesTheWallsFromTheFloorToTheirHeight) {
  const TemporaryFile file("map.yaml", std::string(kMap) + "wall_height_m: 2.0\nceiling_m: 2.4\n");
  file.add("map.pgm", pgm());
  const RayScene scene(load_world(file.path()));
  const Eigen::Vector3f place(-0.25f, 2.75f, 1.0f);
  EXPECT_NEAR(range_along(scene, place, {1, 0, 0}), 2.75, 1e-5);
  EXPECT_NEAR(range_along(scene, place, {0, 1, 0}), 1.75, 1e-5);
  EXPECT_NEAR(range_along(scene, place, {0, 0, -1}), 1.0, 1e-5);
  EXPECT_NEAR(range_along(scene, place, {0, 0, 1}), 1.4, 1e-5);
  EXPECT_TRUE(std::isinf(range_along(scene, {-0.25f, 2.75f, 2.1f}, {1, 0, 0})));
}

TEST(MapServer, TheOriginTurnsTheMap) {
  const TemporaryFile file("map.yaml",
                           "image: map.pgm\nresolution: 0.5\norigin: [0, 0, 1.5707963267948966]\n");
  file.add("map.pgm", pgm());
  const World world = load_world(file.path());
  EXPECT_TRUE(occupied_at(world, {-1.25, 1.75}));   // the block in the middle
  EXPECT_FALSE(occupied_at(world, {-1.25, 0.75}));  // west of it
}

TEST(MapServer, StartsWhereToldOrWhereMostSpaceIsFree) {
  const TemporaryFile file("map.yaml", kMap);
  file.add("map.pgm", pgm());
  const World found = load_world(file.path());
  EXPECT_NO_THROW(Simulation(found, SimulationConfig{}));
  file.add("map.yaml", std::string(kMap) + "start: {x_m: 0.25, y_m: 4.25, yaw_deg: 90}\n");
  const World told = load_world(file.path());
  EXPECT_NEAR(told.truth.T_world_start.y_m, 4.25, 1e-9);
  EXPECT_NEAR(told.truth.T_world_start.yaw_rad, kPi / 2, 1e-9);
}

TEST(MapServer, StartsNowhereThatNobodyHasSeen) {
  const TemporaryFile file("map.yaml", "image: map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\n");
  for (const char unknown : {'\x80', '\xcd'}) {  // but for three columns on the right
    std::string grey = "P5\n8 6\n255\n" + std::string(48, unknown);
    for (std::size_t row = 0; row < 6; ++row) grey.replace(grey.size() - 48 + 8 * row + 5, 3, "\xff\xff\xff");
    file.add("map.pgm", grey);
    EXPECT_GT(load_world(file.path()).truth.T_world_start.x_m, 2.5);
  }
}

TEST(MapServer, APngGivesTheSameWorldAsThePgm) {
  const TemporaryFile file("map.yaml", kMap);
  file.add("map.pgm", pgm());
  const World from_pgm = load_world(file.path());
  file.add("map.yaml", std::string(kMap).replace(std::string(kMap).find(".pgm"), 4, ".png"));
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = 8;
  png.height = 6;
  png.format = PNG_FORMAT_GRAY;
  const std::string bytes = pixels();
  ASSERT_TRUE(
      png_image_write_to_file(&png, (file.folder() + "/map.png").c_str(), 0, bytes.data(), 0, nullptr));
  const World from_png = load_world(file.path());
  ASSERT_EQ(from_png.solids.size(), from_pgm.solids.size());
  for (std::size_t i = 0; i < from_png.solids.size(); ++i)
    EXPECT_EQ(from_png.solids[i].base, from_pgm.solids[i].base);
}

TEST(MapServer, SaysWhatIsWrongWithTheImage) {
  const TemporaryFile file("map.yaml", kMap);
  const auto problem = [&file] {
    try {
      load_world(file.path());
    } catch (const ConfigError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(problem().find("map.yaml:1: "), std::string::npos) << problem();
  EXPECT_NE(problem().find("cannot be read: check the path"), std::string::npos);
  file.add("map.pgm", pgm().substr(0, 40));
  EXPECT_NE(problem().find("truncated"), std::string::npos) << problem();
  file.add("map.pgm", "GIF89a");
  EXPECT_NE(problem().find("neither a PGM nor a PNG"), std::string::npos) << problem();
}

}  // namespace
}  // namespace enfilade::simulator
