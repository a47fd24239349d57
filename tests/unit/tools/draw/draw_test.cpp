// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tools/enfilade/draw/figures.hpp"
#include "tools/enfilade/draw/svg.hpp"

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

TEST(FloorPlan, EmptyMapIsStillAPicture) {
  EXPECT_NE(draw_floor_plan({}, "nothing").find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace enfilade::draw
