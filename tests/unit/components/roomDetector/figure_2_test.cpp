// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "components/roomDetector/core/rectangle_search.hpp"

/// The case of the paper's figure 2: all walls of the robot's room are seen, and through its door two walls
/// of the room next door. Walls that lie beyond the room mislead a method that counts whole lines.
namespace enfilade::room_detector {
namespace {

constexpr double kCell_m = 0.05;
constexpr HoughConfig kHough{.range_m = 8.0};

struct Plan {
  std::vector<Point2> points;

  void wall(Point2 from, const Point2& to) {
    const int steps = static_cast<int>(std::lround((to - from).norm() / kCell_m));
    for (int i = 0; i < steps; ++i) points.push_back(from + (i + 0.5) / steps * (to - from));
  }
};

/// 4 × 3 m, a door in the upper wall, an object in a corner.
Plan figure_2() {
  Plan plan;
  plan.wall({-2.0, -1.5}, {2.0, -1.5});
  plan.wall({-2.0, -1.5}, {-2.0, 1.5});
  plan.wall({2.0, -1.5}, {2.0, 1.5});
  plan.wall({-2.0, 1.5}, {-0.1, 1.5});
  plan.wall({0.9, 1.5}, {2.0, 1.5});
  plan.wall({1.1, 1.65}, {1.1, 5.85});  // next door
  plan.wall({-0.8, 5.85}, {1.1, 5.85});
  plan.wall({1.4, -1.0}, {1.8, -1.0});  // an object
  plan.wall({1.4, -1.4}, {1.4, -1.0});
  return plan;
}

HoughSpace space_of(const Plan& plan) {
  HoughSpace space(kHough, Point2::Zero(), kCell_m);
  for (std::size_t i = 0; i < plan.points.size(); ++i) space.set(i, {plan.points[i], 1, 0, 0});
  return space;
}

Rectangle found(const HoughSpace& space, SearchMethod method) {
  const auto best = RectangleSearch({.search = method}, kHough).find_best(space, Point2(0.1, 0.0));
  return best ? space.rectangle(best->rectangle) : Rectangle{};
}

/// One panel of the picture; 40 pixels a metre.
void draw(std::ostream& svg, double left, const char* title, const Plan& plan,
          const std::optional<Rectangle>& room) {
  const auto x = [&](const Point2& p) { return left + 40.0 * (p.x() + 2.6); };
  const auto y = [](const Point2& p) { return 40.0 * (6.6 - p.y()); };
  svg << "<text x='" << left + 8 << "' y='18' font-family='sans-serif' font-size='13'>" << title
      << "</text>\n";
  if (room) {
    svg << "<polygon fill='#cde' stroke='#06c' stroke-width='2' points='";
    for (int i = 0; i < 4; ++i) svg << x(room->corner(i)) << ',' << y(room->corner(i)) << ' ';
    svg << "'/>\n";
  }
  for (const Point2& p : plan.points)
    svg << "<rect width='2' height='2' x='" << x(p) - 1 << "' y='" << y(p) - 1 << "'/>\n";
  svg << "<circle r='5' fill='#c30' cx='" << x({0.1, 0.0}) << "' cy='" << y({0.1, 0.0}) << "'/>\n";
}

/// Drawn into the folder $ENFILADE_PICTURES, if that is set.
void draw_picture(const Plan& plan, const Rectangle& by_lines, const Rectangle& by_segments) {
  const char* folder = std::getenv("ENFILADE_PICTURES");
  if (!folder) return;
  std::ofstream svg(std::string(folder) + "/figure_2.svg");
  svg << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 630 340' width='630' height='340'>\n"
      << "<rect width='630' height='340' fill='white'/>\n";
  draw(svg, 0.0, "(a) occupied columns, robot", plan, std::nullopt);
  draw(svg, 210.0, "(b) by lines", plan, by_lines);
  draw(svg, 420.0, "(c) by segments", plan, by_segments);
  svg << "</svg>\n";
}

TEST(Figure2, WholeLinesAreMisledByTheRoomNextDoorAndSegmentsAreNot) {
  const Plan plan = figure_2();
  const HoughSpace space = space_of(plan);
  const Rectangle by_lines = found(space, SearchMethod::kLines),
                  by_segments = found(space, SearchMethod::kExact);
  draw_picture(plan, by_lines, by_segments);
  EXPECT_NEAR(by_segments.x_m, 0.0, 0.06);
  EXPECT_NEAR(by_segments.y_m, 0.0, 0.06);
  EXPECT_NEAR(by_segments.width_m, 4.0, 0.11);
  EXPECT_NEAR(by_segments.height_m, 3.0, 0.11);
  EXPECT_LT(by_lines.width_m, 3.2);  // the right wall is taken for that of the room next door
}

}  // namespace
}  // namespace enfilade::room_detector
