// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include "tools/room/view.hpp"
#include "tools/support/scratch_folder.hpp"

namespace enfilade::room {
namespace {

using Cells = std::map<std::tuple<int, int, int>, CellState>;

Cells by_place(const Survey& survey) {
  Cells cells;
  for (const GridCell& c : survey.cells) cells[{c.x, c.y, c.z}] = c.state;
  return cells;
}

octomap::point3d centre(int x, int y, int z) {
  const auto metres = [](int cell) { return 0.1F * static_cast<float>(cell) + 0.05F; };
  return {metres(x), metres(y), metres(z)};
}

/// A slab of floor 1 m below the file's origin, a post on it and free space about.
std::string octree_file() {
  octomap::OcTree tree(0.1);
  for (int x = -10; x < 10; ++x) {
    for (int y = -10; y < 10; ++y) {
      tree.updateNode(centre(x, y, -10), true);
      for (int z = -9; z < 8; ++z) tree.updateNode(centre(x, y, z), x == 4 && y == -7);
    }
  }
  tree.toMaxLikelihood();
  tree.prune();
  std::stringstream out;
  tree.writeBinary(out);
  return out.str();
}

TEST(OctreeSurvey, HoldsTheCellsOfTheTreeWithTheFloorAtZero) {
  const Cells cells = by_place(survey_of_octree({"a.bt", octree_file()}));
  EXPECT_EQ(cells.size(), 20u * 20u * 18u);
  EXPECT_EQ(cells.at({-3, 9, 0}), CellState::kOccupied);
  EXPECT_EQ(cells.at({4, -7, 5}), CellState::kOccupied);
  EXPECT_EQ(cells.at({5, -7, 5}), CellState::kFree);
}

TEST(OctreeSurvey, RefusesEveryFileThatIsCutOffAndSurvivesEveryDamage) {
  const std::string whole = octree_file();
  for (std::size_t length = 0; length < whole.size(); length += 7)
    EXPECT_THROW(survey_of_octree({"a.bt", whole.substr(0, length)}), std::runtime_error) << length;
  for (std::size_t at = whole.find("data"); at < whole.size(); at += 5) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0xFF);
    try {
      survey_of_octree({"a.bt", damaged});
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).find("a.bt: "), 0u);
    }
  }
}

TEST(LogSurvey, IsOneLayerAndStandsWhereTheRobotEnded) {
  const Survey survey = survey_of_log({"a.log",
                                       "FLASER 3 2 2 2 0 0 0 0 0 0 1 h 1\n"
                                       "FLASER 3 2 2 2 1 0 0.5 1 0 0.5 2 h 2\n"},
                                      {});
  EXPECT_TRUE(survey.is_planar);
  EXPECT_EQ(survey.T_survey_stand, (Pose2{1.0, 0.0, 0.5}));
  for (const GridCell& c : survey.cells) EXPECT_EQ(c.z, planar_layer(0.05));
  EXPECT_EQ(by_place(survey).at({40, 0, 12}), CellState::kOccupied);
  EXPECT_EQ(by_place(survey).at({20, 0, 12}), CellState::kFree);
}

/// Of rows given from the top.
Survey survey_of_pixels(const std::vector<std::string>& rows) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "drawn.pgm";
  std::ofstream out(file, std::ios::binary);
  out << "P5\n" << rows.front().size() << " " << rows.size() << "\n255\n";
  for (const std::string& row : rows) out << row;
  out.close();
  return read_survey(file.string(), {});
}

TEST(MapSurvey, FloorOfADrawnPlanEndsInAWallWhateverItsGrey) {
  const std::string row = "\xFF\xFF\xB4\x78\x78\x50\xF0";
  const Cells cells = by_place(survey_of_pixels({row}));
  EXPECT_EQ(cells.at({1, 0, 12}), CellState::kFree);
  EXPECT_EQ(cells.at({2, 0, 12}), CellState::kOccupied) << "its edge is smoothed";
  EXPECT_FALSE(cells.contains({3, 0, 12})) << "grey within a wall says nothing";
  EXPECT_EQ(cells.at({5, 0, 12}), CellState::kOccupied);
  EXPECT_EQ(cells.at({6, 0, 12}), CellState::kFree) << "not quite white, but floor";
}

TEST(MapSurvey, WhatMapServerLeavesUnknownIsNoWall) {
  const Cells cells = by_place(survey_of_pixels({"\xFE\xFE\xCD\xCD\xFE"}));
  EXPECT_EQ(cells.size(), 3u);
}

/// Of one row of black, map_server's unknown and white, with this YAML.
Survey survey_of_row(const std::string& yaml) {
  const ScratchFolder scratch;
  std::ofstream(scratch.path() / "row.pgm", std::ios::binary) << "P5\n3 1\n255\n"
                                                              << std::string("\0\xCD\xFF", 3);
  std::ofstream(scratch.path() / "row.yaml") << "image: row.pgm\nresolution: 0.05\n" << yaml;
  return read_survey((scratch.path() / "row.yaml").string(), {});
}

TEST(MapSurvey, GreysMeanWhatTheYamlSays) {
  const Cells plain = by_place(survey_of_row("origin: [0, 0, 0]\n"));
  EXPECT_EQ(plain, (Cells{{{0, 0, 12}, CellState::kOccupied}, {{2, 0, 12}, CellState::kFree}}));
  const Cells negated = by_place(survey_of_row("origin: [0, 0, 0]\nnegate: 1\noccupied_thresh: 0.9\n"));
  EXPECT_EQ(negated, (Cells{{{0, 0, 12}, CellState::kFree}, {{2, 0, 12}, CellState::kOccupied}}));
}

TEST(MapSurvey, NamesEachLineOfTheYamlThatIsWrong) {
  try {
    survey_of_row("origin: [0, 0]\nfree_thresh: low\n");
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("row.yaml:3: 'origin'"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("row.yaml:4: 'free_thresh'"), std::string::npos) << error.what();
  }
}

/// Two squares of free cells with walls around them and between them.
Survey two_cabinets() {
  Survey survey{.resolution_m = 0.1, .is_fused = true, .is_planar = true};
  for (int x = 0; x <= 60; ++x) {
    for (int y = 0; y <= 30; ++y) {
      const bool is_wall = x % 40 == 0 || x == 60 || y % 30 == 0;
      survey.cells.push_back(grid_builder::to_grid_cell({x, y, planar_layer(0.1)},
                                                        is_wall ? CellState::kOccupied : CellState::kFree));
    }
  }
  return survey;
}

TEST(View, ShowsTheWallsAboutButNothingBehindThem) {
  const Cells seen = by_place(seen_from({1.0, 1.0}, two_cabinets()));
  EXPECT_TRUE(seen.contains({40, 15, 6}));
  EXPECT_TRUE(seen.contains({20, 20, 6}));
  EXPECT_FALSE(seen.contains({50, 15, 6}));
  EXPECT_FALSE(seen.contains({60, 15, 6}));
}

TEST(RoomiestPlace, IsTheMiddleOfTheLargestFreeSquare) {
  const Pose2 place = roomiest_place(two_cabinets());
  EXPECT_NEAR(place.x_m, 2.05, 0.55) << "the larger of the two";
  EXPECT_NEAR(place.y_m, 1.55, 0.11);
}

TEST(Survey, RefusesWhatItDoesNotKnowWithASentence) {
  EXPECT_THROW(read_survey("scan.xyz", {}), std::runtime_error);
  EXPECT_THROW(read_survey("missing.bt", {}), std::runtime_error);
}

}  // namespace
}  // namespace enfilade::room
