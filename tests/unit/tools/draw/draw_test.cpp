// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include "tools/draw/figures.hpp"
#include "tools/draw/svg.hpp"
#include "tools/draw/wall_place.hpp"

namespace enfilade::draw {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(SvgCanvas, YPointsUpAndTextIsEscaped) {
  Bounds bounds;
  bounds.include(Point2(0.0, 0.0));
  bounds.include(Point2(10.0, 10.0));
  SvgCanvas canvas(bounds, 100.0, 0.0, 0.0);
  canvas.line({0.0, 0.0}, {10.0, 10.0}, {.stroke = "#000"});
  canvas.text({5.0, 5.0}, "a < b & c", {});
  EXPECT_NE(canvas.str().find("M0.00 1000.00L1000.00 0.00"), std::string::npos);
  EXPECT_NE(canvas.str().find("a &lt; b &amp; c"), std::string::npos);
}

TEST(ScanFigure, PaintsDoorsGreenAndEveryOtherStretchOfWallRed) {
  ScanFigure figure;
  figure.estimate.found = true;
  figure.estimate.rectangle = {.width_m = 4.0, .height_m = 3.0};
  EXPECT_EQ(count(draw_scan(figure), "stroke=\"#c62828\""), 4U + 1U);  // four walls, legend
  figure.estimate.doors = {{.gap = {1, 1.0, 1.9}, .state = DoorState::kOpen}};
  const std::string svg = draw_scan(figure);
  EXPECT_EQ(count(svg, "stroke=\"#c62828\""), 5U + 1U);
  EXPECT_EQ(count(svg, "stroke=\"#2e9e3f\""), 1U + 1U);
}

/// Distance between the text and the nearest thing taken on its wall; negative where they overlap.
double clearance_m(const WallPlace& place, const std::vector<WallInterval>& taken, double text_m) {
  double least = 1e9;
  for (const WallInterval& t : taken)
    if (t.wall == place.wall)
      least = std::min(least, std::max(t.from_m - place.along_m, place.along_m - t.to_m) - 0.5 * text_m);
  return least;
}

TEST(WallPlace, ADimensionStandsInTheMiddleUnlessADoorIsThere) {
  const Rectangle room{0.0, 0.0, 0.0, 4.0, 3.0};
  EXPECT_DOUBLE_EQ(place_dimension(room, 3, {}, 0.6).along_m, 0.5 * room.wall_length_m(3));
  for (double from_m = 0.0; from_m <= 3.1; from_m += 0.1) {
    const std::vector<WallInterval> taken{{3, from_m, from_m + 0.9}};
    const WallPlace place = place_dimension(room, 3, taken, 0.6);
    EXPECT_EQ(place.wall, 3);
    EXPECT_GT(clearance_m(place, taken, 0.6), 0.05) << from_m;
    EXPECT_GT(std::min(place.along_m, room.wall_length_m(3) - place.along_m), 0.5) << from_m;
  }
}

TEST(WallPlace, ADimensionGoesToTheOppositeWallWhereItsOwnIsFull) {
  const Rectangle room{0.0, 0.0, 0.0, 2.0, 5.0};
  const int narrow = room.wall_length_m(2) < 3.0 ? 2 : 3;
  std::vector<WallInterval> taken{{static_cast<std::uint8_t>(narrow), 0.5, 1.5}};
  EXPECT_EQ(place_dimension(room, narrow, taken, 0.6).wall, (narrow + 2) % 4);
  taken.push_back({static_cast<std::uint8_t>((narrow + 2) % 4), 0.5, 1.5});
  const WallPlace inside = place_dimension(room, narrow, taken, 0.6);
  EXPECT_GT(inside.inside_m, WallPlace{}.inside_m) << "both are full";
}

TEST(SvgCanvas, TheBarIsLongEnoughToBeSeen) {
  Bounds bounds;
  bounds.include(Point2(0.0, 0.0));
  bounds.include(Point2(40.0, 30.0));
  for (const auto& [pixels_per_m, metres] : {std::pair{80.0, "1 m"}, std::pair{12.0, "5 m"}}) {
    SvgCanvas canvas(bounds, pixels_per_m);
    canvas.legend({});
    EXPECT_NE(canvas.str().find(std::string(">") + metres + "<"), std::string::npos);
  }
}

TEST(SvgCanvas, ALegendThatIsTooLongGoesOnInTheNextRow) {
  Bounds bounds;
  bounds.include(Point2(0.0, 0.0));
  bounds.include(Point2(1.0, 1.0));
  SvgCanvas canvas(bounds, 80.0);  // 320 px wide
  canvas.legend({{{}, "so many"}, {{}, "long words"}, {{}, "do not fit"}, {{}, "in"}});
  EXPECT_EQ(count(canvas.str(), "<path d=\"M12.0 "), 2U);
}

TEST(FloorPlan, EmptyMapIsStillAPicture) {
  EXPECT_NE(draw_floor_plan({}, "nothing").find("</svg>"), std::string::npos);
}

TEST(FloorPlan, ShowsABlockedAndAClosedDoorAsShut) {
  TopologicalMap map;
  map.rooms.push_back({.id = 1, .width_m = 4.0, .height_m = 3.0});
  map.doors.push_back({.id = 1, .kind = DoorKind::kPassage, .face = {1, {0, 1.0, 2.0}}});
  const std::string open = draw_floor_plan(map, "open");
  EXPECT_EQ(open.find("blocked or closed"), std::string::npos);
  map.doors[0].closed = true;
  const std::string closed = draw_floor_plan(map, "open");
  EXPECT_NE(closed.find("blocked or closed"), std::string::npos);
  map.doors[0].closed = false;
  map.doors[0].kind = DoorKind::kBlocked;
  EXPECT_EQ(draw_floor_plan(map, "open"), closed);
}

}  // namespace
}  // namespace enfilade::draw
