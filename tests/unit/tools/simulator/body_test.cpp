// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/body.hpp"

#include <gtest/gtest.h>

#include "tests/unit/tools/simulator/test_worlds.hpp"
#include "tools/simulator/core/traffic.hpp"

namespace enfilade::simulator {
namespace {

constexpr double kWallStop_m =
    2.0 - 0.22;  ///< where a robot that drives east in a room 4 m wide touches the wall

void drive(Simulation& simulation, double m_s, double duration_s) {
  const double wheel_rad_s = m_s / 0.08;
  simulation.actuate({wheel_rad_s, wheel_rad_s, 0.0});
  for (int i = 0; i < duration_s * 200; ++i) simulation.step();
}

TEST(Body, StopsAtAWallAndCountsOneCollisionPerContact) {
  Simulation simulation(build_world(test::one_room(4.0, 3.0)), test::without_noise());
  drive(simulation, 0.5, 5.0);
  EXPECT_NEAR(simulation.ground_truth().T_world_base.x_m, kWallStop_m, 0.005);
  EXPECT_LE(simulation.ground_truth().T_world_base.x_m, kWallStop_m);
  EXPECT_EQ(simulation.ground_truth().collisions, 1u);
  drive(simulation, -0.5, 2.0);  // it can leave
  EXPECT_LT(simulation.ground_truth().T_world_base.x_m, 1.3);
  drive(simulation, 0.5, 3.0);
  EXPECT_EQ(simulation.ground_truth().collisions, 2u);
}

TEST(Body, CannotBeDrivenThroughAWallByManyShortPushes) {
  Simulation simulation(build_world(test::one_room(4.0, 3.0)), test::without_noise());
  for (int i = 0; i < 50; ++i) drive(simulation, 0.6, 0.4), drive(simulation, -0.1, 0.05);
  EXPECT_LE(simulation.ground_truth().T_world_base.x_m, kWallStop_m);
}

TEST(Body, PassesUnderAndOverWhatIsNotInItsWay) {
  FloorPlan plan = test::one_room(6.0, 3.0);
  plan.furniture.push_back({outline({.x_m = 1.0, .width_m = 0.2, .height_m = 3.0}), 0.8, 1.2, false});
  plan.furniture.push_back({outline({.x_m = 1.5, .width_m = 0.2, .height_m = 3.0}), 0.0, 0.005, false});
  Simulation simulation(build_world(plan), test::without_noise());
  drive(simulation, 0.5, 4.5);
  EXPECT_EQ(simulation.ground_truth().collisions, 0u);
  EXPECT_GT(simulation.ground_truth().T_world_base.x_m, 1.9);
}

TEST(Body, RefusesAStartInsideFurniture) {
  FloorPlan plan = test::one_room(4.0, 3.0);
  plan.furniture.push_back({outline({.x_m = 0.2, .width_m = 0.2, .height_m = 0.2}), 0.0, 0.5, false});
  EXPECT_THROW(Simulation(build_world(plan), {}), std::invalid_argument);
}

World with_walker() {
  FloorPlan plan = test::one_room(6.0, 6.0);
  MovingSolid walker;
  walker.solid = {circle_outline(Point2::Zero(), 0.4), 0.0, 1.7, false};
  walker.waypoints = {{2.0, -1.0}, {2.0, 1.0}};
  walker.speed_m_s = 1.0;
  plan.moving.push_back(walker);
  return build_world(plan);
}

TEST(Traffic, WalksToAndFroBetweenItsWaypoints) {
  Traffic traffic(with_walker(), 0.22, 0.7);
  for (int i = 0; i < 300; ++i) traffic.step(0.005, {-2, -2});
  EXPECT_NEAR(traffic.positions()[0].y(), 0.5, 1e-9);
  for (int i = 0; i < 300; ++i) traffic.step(0.005, {-2, -2});
  EXPECT_NEAR(traffic.positions()[0].y(), 0.0, 1e-9);
}

TEST(Traffic, WaitsForARobotInItsWayAndGoesOnAfterwards) {
  Traffic traffic(with_walker(), 0.22, 0.7);
  for (int i = 0; i < 500; ++i) traffic.step(0.005, {2.0, 0.3});
  EXPECT_LT(traffic.positions()[0].y(), 0.3 - 0.4);
  const double waiting_at = traffic.positions()[0].y();
  for (int i = 0; i < 20; ++i) traffic.step(0.005, {-2, -2});
  EXPECT_NEAR(traffic.positions()[0].y(), waiting_at + 0.1, 1e-9);
}

TEST(Traffic, TurnsRoundBeforeARobotThatStays) {
  Traffic traffic(with_walker(), 0.22, 0.7);
  for (int i = 0; i < 500; ++i) traffic.step(0.005, {2.0, 0.3});
  const double waiting_at = traffic.positions()[0].y();
  for (int i = 0; i < 700; ++i) traffic.step(0.005, {2.0, 0.3});
  EXPECT_LT(traffic.positions()[0].y(), waiting_at - 0.3);
  for (int i = 0; i < 8000; ++i) {  // caught between two waypoints it goes back and forth for ever
    traffic.step(0.005, {2.0, 0.3});
    ASSERT_LE(traffic.positions()[0].y(), waiting_at + 0.01);
  }
}

TEST(Traffic, IsSeenByTheLaserWhereItIsNow) {
  RayScene scene(with_walker());
  EXPECT_NEAR(test::range_along(scene, {0, -1, 1}, {1, 0, 0}), 1.8, 2e-3);
  const Point2 elsewhere(1.0, 0.0);
  scene.place_moving({&elsewhere, 1});
  EXPECT_NEAR(test::range_along(scene, {0, -1, 1}, {1, 0, 0}), 3.0, 1e-3);
  EXPECT_NEAR(test::range_along(scene, {0, 0, 1}, {1, 0, 0}), 0.8, 2e-3);
}

}  // namespace
}  // namespace enfilade::simulator
