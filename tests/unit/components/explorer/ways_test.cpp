// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/core/ways.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/explorer/core/safety_guard.hpp"
#include "interfaces/geometry/segment.hpp"
#include "tests/unit/components/explorer/machine_world.hpp"

namespace enfilade::explorer {
namespace {

/// A room cut in two by a wall with a gap of so many cells; the door is in the far half.
SyntheticRoom two_halves(int gap_cells) {
  const double y0 = 2.0, y1 = y0 + 0.05 * gap_cells;
  return SyntheticRoom().room(0, 0, 4, 4).solid(2.0, 0, 2.1, 4.0, 0.0, 0.5).free(2.0, y0, 2.1, y1);
}

FloorMap map_of(const SyntheticRoom& room) { return FloorMap(room.grid(), {}, {}); }

/// Of the path itself, to the centres of the obstacle cells of the uncut map.
double exact_clearance_m(const FloorMap& map, const Path& path) {
  double least_m = 10.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(map.width() * map.height()); ++i) {
    const CellXY c = map.cell(i);
    if (map.floor(c) != Floor::kObstacle) continue;
    for (std::size_t k = 1; k < path.points.size(); ++k)
      least_m = std::min(least_m, distance(map.centre(c), Segment{path.points[k - 1], path.points[k]}));
  }
  return least_m;
}

TEST(Ways, ANarrowOneLeadsThroughAGapThatTheUsualRasterCannotTellToBeWideEnough) {
  const FloorMap map = map_of(two_halves(10));
  Ways ways(map, {}, {1, 1});
  EXPECT_FALSE(ways.usual().path_to({3, 1}));
  const auto path = ways.narrow().path_to({3, 1});
  ASSERT_TRUE(path);
  EXPECT_GE(exact_clearance_m(map, *path), PathPlannerConfig{}.narrow_radius_m - 0.01);
}

TEST(Ways, NoneLeadsThroughAGapAsWideAsTheRobot) {
  Ways ways(map_of(two_halves(9)), {}, {1, 1});
  EXPECT_FALSE(ways.narrow().path_to({3, 1}));
}

TEST(Ways, NoneIsNarrowWhereTheLeastDistanceIsTheUsualOne) {
  Ways ways(map_of(two_halves(10)), {.narrow_radius_m = 0.27}, {1, 1});
  EXPECT_FALSE(ways.narrow().path_to({3, 1}));
}

TEST(Ways, ARefinedMapTellsTheSameDistancesThreeTimesAsFinely) {
  const FloorMap map = map_of(SyntheticRoom().room(0, 0, 2, 2).solid(1.0, 1.0, 1.05, 1.05));
  const FloorMap fine = map.refined();
  const CellXY same = fine.cell_at({0.525, 1.025}), beside = fine.cell_at({0.545, 1.025});
  EXPECT_NEAR(fine.to_obstacle_m(same), map.to_obstacle_m(map.cell_at({0.525, 1.025})), 1e-5);
  EXPECT_NEAR(fine.to_obstacle_m(beside), 1.025 - fine.centre(beside).x(), 1e-5);
  EXPECT_EQ(fine.floor(fine.cell_at({1.002, 1.048})), Floor::kObstacle);
  EXPECT_EQ(fine.floor(fine.cell_at({0.998, 1.048})), Floor::kFree);
}

/// Two things, the near sides of which the robot sees only when it stands between them and the corner.
struct NicheWorld : MachineWorld {
  NicheWorld() {
    EXPECT_TRUE(run_until(ExplorationPhase::kFixing, 200));
    const auto snapped = [](double v) { return 0.05 * std::round(v / 0.05); };
    const Point2 p(snapped(pose.x_m), snapped(pose.y_m));
    const auto box = [&](double x0, double y0, double x1, double y1) {
      things.push_back({p.x() + x0, p.y() + y0, p.x() + x1, p.y() + y1});
      grid.apply(0.05, SyntheticRoom().solid(p.x() + x0, p.y() + y0, p.x() + x1, p.y() + y1, 0, 0.5).cells());
    };
    box(-0.6, -0.6, 0.6, -0.45);
    box(-0.6, 0.45, 0.6, 0.6);
    box(-0.6, -0.6, -0.45, 0.6);
    box(0.45, -0.6, 0.6, -0.25);
    box(0.45, 0.25, 0.6, 0.6);
  }
  struct Box {
    double x0, y0, x1, y1;
  };
  std::vector<Box> things;
};

TEST(Ways, TheRobotGetsOutOfANicheThatIsNarrowerThanItTookItToBe) {
  NicheWorld world;
  double nearest_m = 10.0, fastest_m_s = 0.0;
  for (int i = 0; i < 4000 && world.machine.state().phase != ExplorationPhase::kEntering; ++i) {
    const Point2 before = world.pose.translation();
    world.tick();
    double to_things_m = 10.0;
    for (const auto& b : world.things) {
      const Point2 p = world.pose.translation();
      const Point2 q(std::clamp(p.x(), b.x0, b.x1), std::clamp(p.y(), b.y0, b.y1));
      to_things_m = std::min(to_things_m, (p - q).norm());
    }
    nearest_m = std::min(nearest_m, to_things_m);
    if (to_things_m < 0.25)
      fastest_m_s = std::max(fastest_m_s, (world.pose.translation() - before).norm() / kDt);
  }
  EXPECT_EQ(world.machine.state().phase, ExplorationPhase::kEntering);
  EXPECT_FALSE(world.said("there is no way to it"));
  EXPECT_GT(nearest_m, SafetyGuardConfig{}.robot_radius_m) << "it touched one of the things";
  EXPECT_LE(fastest_m_s, DriveConfig{}.narrow_speed_m_s + 0.02);
}

}  // namespace
}  // namespace enfilade::explorer
