// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/zone_pictures.hpp"

#include <sstream>

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include "components/gridBuilder/core/octree.hpp"
#include "tests/unit/components/gridBuilder/box_room.hpp"

namespace enfilade::grid_builder {
namespace {

const Eigen::Vector3d kSensorPlace{0.1037, 0.0211, 0.6013};

std::string as_text(const std::vector<std::int8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

/// What OctoMap itself writes of the grid.
std::string written_by_octomap(const ZoneGrid& grid) {
  const auto tree = to_octree(grid);
  tree->toMaxLikelihood();
  tree->prune();
  std::ostringstream stream;
  tree->writeBinaryData(stream);
  return stream.str();
}

struct ZonePicturesOfARoom : testing::Test {
  ZonePicturesOfARoom() {
    std::mt19937 engine(3);
    room = BoxRoom::random(engine);
    pictures.follow(grid);
  }

  void see(int lines) {
    for (int i = 0; i < lines; ++i) {
      ++stamp;
      const ScanLine line = room.scan(stamp, kSensorPlace, radians(4.3 * static_cast<double>(stamp)), 361);
      pictures.note(grid.insert(line).changes);
    }
  }

  void draw_all() {
    while (pictures.draw(grid, 7)) {
    }
  }

  ZoneGrid grid{{}};
  ZonePictures pictures{{}};
  BoxRoom room;
  StampNs stamp = 0;
};

TEST_F(ZonePicturesOfARoom, OctreeIsByteForByteWhatOctoMapWrites) {
  for (int i = 0; i < 4; ++i) {
    see(10);
    draw_all();
    ASSERT_GT(pictures.octree().size(), 1000u);
    ASSERT_EQ(as_text(pictures.octree()), written_by_octomap(grid)) << i;
  }
}

TEST_F(ZonePicturesOfARoom, OctreeIsReadBackWithTheStatesOfTheGrid) {
  see(40);
  draw_all();
  std::unique_ptr<octomap::AbstractOcTree> made(octomap::AbstractOcTree::createTree("OcTree", 0.05));
  auto* tree = dynamic_cast<octomap::OcTree*>(made.get());
  ASSERT_TRUE(tree);
  std::istringstream stream(as_text(pictures.octree()));
  tree->readBinaryData(stream);
  for (int x = -85; x < 85; ++x) {
    for (int y = -85; y < 85; ++y) {
      for (int z = -2; z < 70; ++z) {
        const auto key = [](int i) { return static_cast<octomap::key_type>(i + 32768); };
        const auto* node = tree->search(octomap::OcTreeKey(key(x), key(y), key(z)));
        const CellState read = !node                         ? CellState::kUnexplored
                               : tree->isNodeOccupied(*node) ? CellState::kOccupied
                                                             : CellState::kFree;
        ASSERT_EQ(read, grid.state({x, y, z})) << x << " " << y << " " << z;
      }
    }
  }
}

TEST_F(ZonePicturesOfARoom, OctreeHoldsCellsFarFromTheOriginToo) {
  for (const double at : {-1500.0, 1400.0}) {
    const auto x = static_cast<float>(at);
    pictures.note(grid.insert({++stamp, {x, 0, 1}, {{x + 2, 3, 1}, {x - 1, -700, 2}}, {}}).changes);
  }
  draw_all();
  EXPECT_EQ(as_text(pictures.octree()), written_by_octomap(grid));
}

TEST_F(ZonePicturesOfARoom, FloorIsTheProjectionOfTheCellsBetweenItsHeights) {
  see(40);
  draw_all();
  const OccupancyMap map = pictures.floor(0.05, Point2::Zero());
  ASSERT_EQ(map.cells.size(), std::size_t{map.columns} * map.rows);
  const int low_x = static_cast<int>(std::lround(map.T_frame_cells.x_m / 0.05));
  const int low_y = static_cast<int>(std::lround(map.T_frame_cells.y_m / 0.05));
  int occupied = 0;
  for (int row = 0; row < static_cast<int>(map.rows); ++row) {
    for (int column = 0; column < static_cast<int>(map.columns); ++column) {
      CellState most = CellState::kUnexplored;  // cells 2 … 19 have their centres in 0.1 … 1 m
      for (int z = 2; z < 20; ++z) most = std::max(most, grid.state({low_x + column, low_y + row, z}));
      const int expected = most == CellState::kOccupied ? 100 : most == CellState::kFree ? 0 : -1;
      const auto at = static_cast<std::size_t>(row) * map.columns + static_cast<std::size_t>(column);
      ASSERT_EQ(map.cells[at], expected) << column << " " << row;
      occupied += most == CellState::kOccupied;
    }
  }
  EXPECT_GT(occupied, 300);
}

TEST_F(ZonePicturesOfARoom, FloorIsCutOffAboutTheRobotWhereItIsTooLarge) {
  see(40);
  pictures = ZonePictures({.max_floor_cells = 400});
  pictures.follow(grid);
  draw_all();
  const OccupancyMap map = pictures.floor(0.05, {0.1, 0.0});
  EXPECT_EQ(map.columns, 20u);
  EXPECT_EQ(map.rows, 20u);
  EXPECT_NEAR(map.T_frame_cells.x_m, -0.4, 1e-9);
  EXPECT_NEAR(map.T_frame_cells.y_m, -0.5, 1e-9);
}

TEST_F(ZonePicturesOfARoom, AreOfTheWholeGridWhereTheFollowingBeginsLate) {
  see(20);
  ZonePictures late({});
  late.note(grid.insert(room.scan(++stamp, kSensorPlace, 0.3, 361)).changes);
  EXPECT_EQ(late.left(), 0u);  // nobody wants it yet
  late.follow(grid);
  while (late.draw(grid, 100)) {
  }
  EXPECT_EQ(as_text(late.octree()), written_by_octomap(grid));
}

TEST_F(ZonePicturesOfARoom, AreEmptyAfterTheGridWas) {
  see(5);
  draw_all();
  grid.clear();
  pictures.clear();
  EXPECT_TRUE(pictures.octree().empty());
  EXPECT_TRUE(pictures.floor(0.05, Point2::Zero()).cells.empty());
  see(5);
  draw_all();
  EXPECT_EQ(as_text(pictures.octree()), written_by_octomap(grid));
}

TEST_F(ZonePicturesOfARoom, NeedWorkOnlyWhereCellsHaveChanged) {
  see(84);  // every roll angle of the round
  draw_all();
  const ScanLine again = room.scan(++stamp, kSensorPlace, radians(4.3 * 84.0), 361);
  pictures.note(grid.insert(again).changes);
  EXPECT_LT(pictures.left(), grid.tile_count() / 4);
}

}  // namespace
}  // namespace enfilade::grid_builder
