// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tools/enfilade/room/find_room.hpp"

namespace enfilade::room {
namespace {

/// A plan of a 5 × 4 m room, inner size, with a 0.9 m door in its right wall, and a second room behind it.
std::string write_plan() {
  constexpr int kColumns = 200, kRows = 120;
  std::string pixels(kColumns * kRows, '\xCD');
  const auto draw = [&](int x_from, int x_to, int y_from, int y_to, char grey) {
    for (int y = y_from; y < y_to; ++y)
      for (int x = x_from; x < x_to; ++x)
        pixels[static_cast<std::size_t>((kRows - 1 - y) * kColumns + x)] = grey;
  };
  draw(18, 180, 18, 102, '\x00');
  draw(20, 120, 20, 100, '\xFE');
  draw(122, 178, 20, 100, '\xFE');
  draw(120, 122, 50, 68, '\xFE');
  const auto folder = std::filesystem::path(testing::TempDir());
  std::ofstream(folder / "plan.pgm", std::ios::binary) << "P5\n"
                                                       << kColumns << " " << kRows << "\n255\n"
                                                       << pixels;
  std::ofstream(folder / "plan.yaml") << "image: plan.pgm\nresolution: 0.05\norigin: [-10.0, -4.0, 0.0]\n";
  return (folder / "plan.yaml").string();
}

TEST(FindRoom, FindsTheRoomOfAPlanAndItsDoorInTheCoordinatesOfTheMap) {
  const FoundRoom room = find_room(read_survey(write_plan(), {}), {}, Point2(-7.0, -1.0));
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

TEST(FindRoom, AnswersWithNullsWhereThereIsNoRoom) {
  Survey nothing{.is_fused = true, .is_planar = true};
  const FoundRoom room = find_room(nothing, {}, Point2(0.0, 0.0));
  EXPECT_FALSE(room.estimate.found);
  EXPECT_TRUE(nlohmann::json::parse(to_json(room))["x_m"].is_null());
  EXPECT_NE(to_svg(room, "empty").find("<svg"), std::string::npos);
}

}  // namespace
}  // namespace enfilade::room
