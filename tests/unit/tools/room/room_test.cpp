// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tools/room/find_room.hpp"
#include "tools/support/scratch_folder.hpp"

namespace enfilade::room {
namespace {

constexpr int kColumns = 200, kRows = 120;

struct Box {
  int x_from, x_to, y_from, y_to;  // pixels from the lower left corner
};

/// A map of 10 × 6 m, black with white boxes in the grey of the unknown.
Survey survey_of_map(const Box& black, std::initializer_list<Box> white) {
  std::string pixels(kColumns * kRows, '\xCD');
  const auto draw = [&](const Box& box, char grey) {
    for (int y = box.y_from; y < box.y_to; ++y)
      for (int x = box.x_from; x < box.x_to; ++x)
        pixels[static_cast<std::size_t>((kRows - 1 - y) * kColumns + x)] = grey;
  };
  draw(black, '\x00');
  for (const Box& box : white) draw(box, '\xFE');
  const ScratchFolder scratch;
  const auto& folder = scratch.path();
  std::ofstream(folder / "plan.pgm", std::ios::binary) << "P5\n"
                                                       << kColumns << " " << kRows << "\n255\n"
                                                       << pixels;
  std::ofstream(folder / "plan.yaml") << "image: plan.pgm\nresolution: 0.05\norigin: [-10.0, -4.0, 0.0]\n";
  return read_survey((folder / "plan.yaml").string(), {});
}

/// A 5 × 4 m room, inner size, with a 0.9 m door in its right wall, and a second room behind it.
Survey survey_of_plan() {
  return survey_of_map({18, 180, 18, 102}, {{20, 120, 20, 100}, {122, 178, 20, 100}, {120, 122, 50, 68}});
}

TEST(FindRoom, FindsTheRoomOfAPlanAndItsDoorInTheCoordinatesOfTheMap) {
  const FoundRoom room = find_room(survey_of_plan(), {}, Point2(-7.0, -1.0));
  ASSERT_TRUE(room.estimate.found);
  const Rectangle& r = room.estimate.rectangle;
  EXPECT_NEAR(r.x_m, -6.5, 0.05);
  EXPECT_NEAR(r.y_m, -1.0, 0.05);
  EXPECT_NEAR(r.width_m, 5.0, 0.11);
  EXPECT_NEAR(r.height_m, 4.0, 0.11);
  const auto json = nlohmann::json::parse(to_json(room));
  ASSERT_EQ(json["doors"].size(), 1u);
  EXPECT_EQ(json["doors"][0]["state"], "open");
  EXPECT_TRUE(json["doors"][0]["height_m"].is_null()) << "a plan knows nothing of heights";
  EXPECT_NEAR(json["doors"][0]["x_m"].get<double>(), -4.0, 0.1);
  EXPECT_NEAR(json["doors"][0]["y_m"].get<double>(), -1.05, 0.1);
  EXPECT_NEAR(json["doors"][0]["width_m"].get<double>(), 0.9, 0.11);
}

TEST(FindRoom, TakesTheWallsOfAMapToBeginWhereFreeFloorEnds) {
  for (const int thick : {1, 2, 4, 8}) {
    const Survey survey = survey_of_map({0, 100, 0, 90}, {{thick, 80 + thick, thick, 60 + thick}});
    const FoundRoom room = find_room(survey, {}, std::nullopt);
    ASSERT_TRUE(room.estimate.found) << thick;
    EXPECT_NEAR(room.estimate.rectangle.width_m, 4.0, 0.005) << thick;
    EXPECT_NEAR(room.estimate.rectangle.height_m, 3.0, 0.005) << thick;
  }
}

TEST(FindRoom, TellsARoomFromTheCorridorBehindItsOpenDoorThoughThereIsNoLintel) {
  const Survey survey =
      survey_of_map({0, 200, 18, 120}, {{60, 120, 20, 80}, {80, 100, 80, 84}, {2, 198, 84, 104}});
  const FoundRoom room = find_room(survey, {}, Point2(-5.5, -1.5));
  ASSERT_TRUE(room.estimate.found);
  EXPECT_NEAR(room.estimate.rectangle.area_m2(), 9.0, 1.0);
}

TEST(FindRoom, TakesTheCubicleAndNotBothThatFaceEachOther) {
  const Survey survey = survey_of_map(
      {0, 200, 0, 120},
      {{60, 116, 10, 46}, {64, 92, 46, 48}, {2, 198, 48, 72}, {64, 92, 72, 74}, {60, 116, 74, 110}});
  const FoundRoom room = find_room(survey, {}, Point2(-6.0, -2.6));
  ASSERT_TRUE(room.estimate.found);
  EXPECT_NEAR(room.estimate.rectangle.height_m, 1.8, 0.16);
  EXPECT_NEAR(room.estimate.rectangle.width_m, 2.8, 0.16);
  const auto& doors = room.estimate.doors;
  EXPECT_EQ(std::count_if(doors.begin(), doors.end(),
                          [](const DoorEstimate& d) { return d.state == DoorState::kOpen; }),
            1);
}

TEST(FindRoom, SaysHowWideACorridorIsOfWhichOneEndWasSeen) {
  Survey survey = survey_of_map({0, 200, 18, 120}, {{2, 200, 20, 64}});
  std::erase_if(survey.cells, [](const GridCell& c) {  // doorways and glass: a third of the walls is left
    return c.x > 4 && c.x % 30 > 9 && c.state == CellState::kOccupied;
  });
  const FoundRoom room = find_room(survey, {}, Point2(-7.0, -2.0));
  ASSERT_TRUE(room.estimate.found);
  EXPECT_NEAR(room.estimate.rectangle.height_m, 2.2, 0.15);
}

TEST(FindRoom, AnswersWithNullsWhereThereIsNoRoom) {
  Survey nothing{.is_fused = true, .is_planar = true};
  const FoundRoom room = find_room(nothing, {}, Point2(0.0, 0.0));
  EXPECT_FALSE(room.estimate.found);
  EXPECT_TRUE(nlohmann::json::parse(to_json(room))["x_m"].is_null());
  EXPECT_NE(to_svg(room, "empty").find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace enfilade::room
