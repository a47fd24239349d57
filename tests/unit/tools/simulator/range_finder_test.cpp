// SPDX-License-Identifier: Apache-2.0
#include "tools/simulator/core/range_finder.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/unit/tools/simulator/test_worlds.hpp"

namespace enfilade::simulator {
namespace {

using test::kCeiling_m;

/// Distance from a point inside a box (walls x = ±w/2, y = ±h/2, floor 0, ceiling c) along `d` to its hull.
double range_in_box(const Eigen::Vector3d& o, const Eigen::Vector3d& d, double w, double h, double c) {
  const auto along = [](double from, double direction, double low, double high) {
    if (direction == 0.0) return 1e9;
    return ((direction > 0 ? high : low) - from) / direction;
  };
  return std::min(
      {along(o.x(), d.x(), -w / 2, w / 2), along(o.y(), d.y(), -h / 2, h / 2), along(o.z(), d.z(), 0, c)});
}

LaserScan line_at(const World& world, const SensorState& at, const SimulationConfig& config, Random& random) {
  const RayScene scene(world);
  RangeFinder laser(config.laser, config.body);
  SensorState to = at;
  to.stamp_ns = at.stamp_ns + RangeFinder::kLine_ns;
  return laser.sense(at, to, scene, random).value();
}

double beam_angle(int i) { return radians(-135.0 + 0.25 * i); }

TEST(RangeFinder, SeesTheWallsOfAnEmptyRoomWhereGeometryPutsThem) {
  const World world = build_world(test::one_room(4.0, 3.0));
  Random random(1);
  SimulationConfig config = test::without_noise();
  config.body.radius_m = config.body.height_m = 1e-4;  // so that only the room is seen
  for (const double roll_deg : {-90.0, -61.0, -30.0, 0.0, 17.0, 45.0, 88.0}) {
    const SensorState at{0, Pose2{0.4, -0.3, 0.6}, radians(roll_deg)};
    const LaserScan line = line_at(world, at, config, random);
    const Point2 o = at.T_world_base * Point2(config.laser.mount_x_m, config.laser.mount_y_m);
    ASSERT_EQ(line.ranges_m.size(), 1081u);
    for (int i = 0; i < 1081; ++i) {
      const double a = beam_angle(i), phi = at.roll_rad;
      const Point2 flat = rotate(at.T_world_base.yaw_rad, {std::cos(a), std::sin(a) * std::cos(phi)});
      const Eigen::Vector3d d(flat.x(), flat.y(), std::sin(a) * std::sin(phi));
      const double expected = range_in_box({o.x(), o.y(), 0.6}, d, 4.0, 3.0, kCeiling_m);
      ASSERT_NEAR(line.ranges_m[i], expected, 1e-3) << "beam " << i << " at roll " << roll_deg;
    }
  }
}

TEST(RangeFinder, TakesEveryBeamAtItsOwnTimeWhileTheMotorTurns) {
  const World world = build_world(test::one_room(4.0, 3.0));
  const RayScene scene(world);
  const SimulationConfig config = test::without_noise();
  RangeFinder laser(config.laser, config.body);
  Random random(1);
  const double speed_rad_s = 2.0;
  SensorState from{0, Pose2{}, 0.3}, to = from;
  std::optional<LaserScan> line;
  for (int step = 0; step < 5 && !line; ++step, from = to) {
    to.stamp_ns += 5'000'000;
    to.roll_rad += speed_rad_s * 0.005;
    line = laser.sense(from, to, scene, random);
  }
  ASSERT_TRUE(line);
  EXPECT_EQ(to.stamp_ns, 20'000'000);  // the last beam is taken at 18.75 ms
  for (int i = 180; i < 1081; i += 7) {
    const double a = beam_angle(i), phi = 0.3 + speed_rad_s * i * 0.025 / 1440;
    const Eigen::Vector3d d(std::cos(a), std::sin(a) * std::cos(phi), std::sin(a) * std::sin(phi));
    EXPECT_NEAR(line->ranges_m[i], range_in_box({0.1, 0.0, 0.6}, d, 4.0, 3.0, kCeiling_m), 1e-3);
  }
}

TEST(RangeFinder, SeesTheLidOfItsOwnRobotBelow) {
  const World world = build_world(test::one_room(4.0, 3.0));
  Random random(1);
  const LaserScan line = line_at(world, {0, Pose2{}, radians(90.0)}, test::without_noise(), random);
  const int straight_down = 180;  // the beam at -90° of a plane that stands upright
  EXPECT_NEAR(line.ranges_m[straight_down], 0.2, 1e-6);
}

TEST(RangeFinder, NoiseHasTheSpreadAskedForNearAndFar) {
  for (const double size_m : {4.0, 24.0}) {
    const World world = build_world(test::one_room(size_m, size_m));
    SimulationConfig config = test::without_noise();
    config.laser.sigma_near_m = 0.01;
    config.laser.sigma_far_m = 0.03;
    config.laser.bias_m = 0.02;
    const SensorState at{};
    Random random(5);
    const LaserScan exact = line_at(world, at, test::without_noise(), random);
    double sum = 0.0, squares = 0.0;
    int n = 0;
    for (int repeat = 0; repeat < 10; ++repeat) {
      const LaserScan noisy = line_at(world, at, config, random);
      for (std::size_t i = 0; i < noisy.ranges_m.size(); ++i, ++n) {
        const double e = noisy.ranges_m[i] - exact.ranges_m[i];
        sum += e;
        squares += e * e;
      }
    }
    const double mean = sum / n, sigma = std::sqrt(squares / n - mean * mean);
    EXPECT_NEAR(mean, 0.02, 0.002);
    EXPECT_NEAR(sigma, size_m < 10 ? 0.01 : 0.03, 0.001);
  }
}

TEST(RangeFinder, DropsTheShareOfBeamsAskedFor) {
  SimulationConfig config = test::without_noise();
  config.laser.dropout_probability = 0.1;
  Random random(2);
  int lost = 0;
  for (int repeat = 0; repeat < 10; ++repeat) {
    const LaserScan line = line_at(build_world(test::one_room(4.0, 3.0)), {}, config, random);
    lost += static_cast<int>(
        std::ranges::count_if(line.ranges_m, [](float r) { return std::isinf(r) && r > 0; }));
  }
  EXPECT_NEAR(lost / 10810.0, 0.1, 0.01);
}

TEST(RangeFinder, MixesOnlyBeamsAtDepthEdges) {
  FloorPlan plan = test::one_room(4.0, 4.0);
  plan.furniture.push_back({outline({.x_m = 1.2, .width_m = 0.3, .height_m = 0.3}), 0.0, 1.0, false});
  const World world = build_world(plan);
  SimulationConfig config = test::without_noise();
  Random random(3);
  const LaserScan sharp = line_at(world, {}, config, random);
  config.laser.mixed_pixel_probability = 1.0;
  const LaserScan mixed = line_at(world, {}, config, random);
  int changed = 0;
  for (int i = 1; i < 1080; ++i) {
    if (sharp.ranges_m[i] == mixed.ranges_m[i]) continue;
    ++changed;
    const float farther = std::max(sharp.ranges_m[i - 1], sharp.ranges_m[i + 1]);
    EXPECT_GT(mixed.ranges_m[i], sharp.ranges_m[i]);
    EXPECT_LT(mixed.ranges_m[i], farther);
    EXPECT_GT(farther - sharp.ranges_m[i], 0.1);
  }
  EXPECT_EQ(changed, 2);  // the box has two edges
}

TEST(RangeFinder, SaysTooCloseAndTooFarAsRep117Does) {
  FloorPlan plan = test::one_room(70.0, 70.0);
  plan.furniture.push_back(
      {outline({.x_m = 0.1 + 0.05 + 0.5, .width_m = 1.0, .height_m = 1.0}), 0.5, 1.0, false});
  Random random(1);
  const LaserScan line = line_at(build_world(plan), {}, test::without_noise(), random);
  EXPECT_EQ(line.ranges_m[540], -std::numeric_limits<float>::infinity());
  EXPECT_EQ(line.ranges_m[1000], std::numeric_limits<float>::infinity());
}

}  // namespace
}  // namespace enfilade::simulator
