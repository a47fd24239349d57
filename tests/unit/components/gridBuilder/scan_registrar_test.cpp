// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/core/scan_registrar.hpp"

#include <gtest/gtest.h>

#include "components/gridBuilder/core/known_walls.hpp"
#include "tests/unit/components/gridBuilder/box_room.hpp"

namespace enfilade::grid_builder {
namespace {

const ScanRegistrarConfig kOn{.register_scans = true};
const BoxRoom kRoom;  // 6.011 × 5.018 m
const KnownWalls kWalls{.rectangle = {0.0, -0.0075, 0.002, 6.011, 5.018}};

/// What a robot sees that stands at `T_zone_base` while odometry says `T_odom_base`.
PlacedLine line(StampNs stamp_ns, const Pose2& T_zone_base, const Pose2& T_odom_base, double roll_rad) {
  const Eigen::Vector3d sensor{T_zone_base.x_m, T_zone_base.y_m, 0.6013};
  PlacedLine placed{{stamp_ns, true, {}, {}}, T_odom_base};
  const Pose2 T_base_zone = T_zone_base.inverse();
  for (const Point3f& p : kRoom.scan(stamp_ns, sensor, roll_rad, 541).hits) {
    const Point2 q = T_base_zone * Point2(p.x_m, p.y_m);
    placed.line.hits.push_back({static_cast<float>(q.x()), static_cast<float>(q.y()), p.z_m});
  }
  return placed;
}

/// One sweep from -90° to 90°; how many lines were given back, and when the first came.
struct Sweep {
  std::size_t given = 0;
  int first_after = 0;
};

Sweep sweep(ScanRegistrar& registrar, const Pose2& T_zone_base, const Pose2& T_odom_base,
            const std::optional<KnownWalls>& walls) {
  Sweep result;
  for (int i = 0; i < 180; ++i) {
    const auto ready = registrar.take(line(i + 1, T_zone_base, T_odom_base, radians(-90.0 + i)), walls);
    if (result.given == 0 && !ready.empty()) result.first_after = i + 1;
    result.given += ready.size();
  }
  return result;
}

void expect_near(const Pose2& a, const Pose2& b, double metres, double degrees_) {
  EXPECT_NEAR((a.translation() - b.translation()).norm(), 0.0, metres);
  EXPECT_NEAR(degrees(wrap_to_pi(a.yaw_rad - b.yaw_rad)), 0.0, degrees_);
}

TEST(WallAlignment, BringsPointsBackOntoTheWallsInSpiteOfFurniture) {
  std::vector<Point2> points;
  const Pose2 error{0.06, -0.09, radians(1.5)};
  for (double x = -3.0; x < 3.0; x += 0.02) {
    points.push_back(error * Point2(x, 2.511));
    if (x < 0.0) points.push_back(error * Point2(x, -2.4));  // a row of cupboards before the wall
    if (x >= 0.0) points.push_back(error * Point2(x, -2.507));
  }
  for (double y = -2.5; y < 2.5; y += 0.02) points.push_back(error * Point2(2.998, y));
  const auto found = align_to_walls(points, kWalls, {0.3, 0.2}, {});
  ASSERT_TRUE(found);
  expect_near(found->T_after_before * error, {}, 0.003, 0.05);
  EXPECT_LT(found->sigma_m, 0.003);
}

TEST(WallAlignment, MovesNothingTheWayThatOneWallAloneDoesNotTell) {
  std::vector<Point2> points;
  for (double x = -2.5; x < 2.5; x += 0.02) points.emplace_back(x, 2.45);
  const auto found = align_to_walls(points, kWalls, {0.0, 0.0}, {});
  ASSERT_TRUE(found);
  expect_near(found->T_after_before, {0.0, 0.061, 0.0}, 0.001, 0.01);
  EXPECT_GT(found->sigma_m, 0.5);
  EXPECT_LT(found->covariance(1, 1), 1e-4);
}

TEST(WallAlignment, FitsNothingToAWallThatHasNotBeenSeen) {
  std::vector<Point2> points;
  for (double y = -2.0; y < 2.0; y += 0.02) {
    points.emplace_back(2.998, y);
    points.emplace_back(-3.111, y);  // the room is longer than it seems
  }
  KnownWalls walls = kWalls;
  walls.seen[2] = false;
  const auto found = align_to_walls(points, walls, {0.0, 0.0}, {});
  ASSERT_TRUE(found);
  expect_near(found->T_after_before, {}, 0.002, 0.05);
}

TEST(KnownWalls, HaveNotBeenSeenWhereTheirPlaceIsUnsure) {
  RoomEstimate estimate{.found = true};
  estimate.rectangle = {0.3, 1.0, 2.0, 4.0, 3.0};
  // Wall 0 moves along the normal n with σ = 1 m, the centre half as far.
  const double n_x = std::cos(0.3), n_y = std::sin(0.3);
  const std::array<double, 5> by_wall_0{0.0, 0.5 * n_x, 0.5 * n_y, 1.0, 0.0};
  estimate.covariance.emplace();
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; j < 5; ++j) (*estimate.covariance)[5 * i + j] = by_wall_0[i] * by_wall_0[j];
  EXPECT_EQ(known_walls(estimate, 0.1).seen, (std::array{false, true, true, true}));
  estimate.covariance.reset();
  EXPECT_EQ(known_walls(estimate, 0.1).seen, (std::array{true, true, true, true}));
}

TEST(ScanRegistrar, TakesTheErrorOfATurnOutBeforeAnyLineIsFused) {
  ScanRegistrar registrar(kOn);
  EXPECT_EQ(sweep(registrar, {0.2, 0.1, 0.0}, {0.2, 0.1, 0.0}, std::nullopt).given, 180u);
  const Pose2 truth{0.21, 0.12, radians(90.0)}, told{0.2, 0.1, radians(91.0)};
  const Sweep turned = sweep(registrar, truth, told, kWalls);
  EXPECT_EQ(turned.given, 180u) << "no line is lost";
  EXPECT_GT(turned.first_after, 1) << "the first lines wait";
  expect_near(registrar.T_zone_odom() * told, truth, 0.002, 0.03);
}

TEST(ScanRegistrar, FindsItsPlaceAfterATurnThatOdometryTellsSixDegreesWrong) {
  ScanRegistrar registrar(kOn);
  sweep(registrar, {0.2, 0.1, 0.0}, {0.2, 0.1, 0.0}, std::nullopt);
  const Pose2 truth{0.21, 0.12, radians(186.0)}, told{0.2, 0.1, radians(180.0)};
  for (int i = 1; i <= 100; ++i) registrar.move(interpolate({0.2, 0.1, 0.0}, told, 0.01 * i));
  EXPECT_EQ(sweep(registrar, truth, told, kWalls).given, 180u);
  expect_near(registrar.T_zone_odom() * told, truth, 0.002, 0.03);
}

/// Root mean square distance from the walls of the returns of four sweeps, a quarter turn between two, where
/// odometry errs by 1° and 20 mm a turn. The room is known roughly, as after one scan.
double smear_m(const ScanRegistrarConfig& config) {
  ScanRegistrar registrar(config);
  const KnownWalls known{.rectangle = {0.001, -0.006, 0.004, 6.013, 5.016}};
  Pose2 T_zone_base{0.4, 0.3, 0.2}, T_odom_base = T_zone_base;
  double squares = 0.0, count = 0.0;
  for (int turn = 0; turn < 4; ++turn) {
    for (int i = 0; i < 90; ++i) {
      const auto walls = turn > 0 ? std::optional(known) : std::nullopt;
      for (const PlacedLine& ready :
           registrar.take(line(i, T_zone_base, T_odom_base, radians(-90.0 + 2 * i)), walls)) {
        for (const Point3f& p : ready.line.hits) {
          if (p.z_m < 0.3 || p.z_m > 2.4) continue;
          const Point2 q =
              registrar.T_zone_odom() * ready.T_odom_base * Point2(p.x_m, p.y_m) - Point2(-0.0075, 0.002);
          const double off = std::min(std::abs(std::abs(q.x()) - 3.0055), std::abs(std::abs(q.y()) - 2.509));
          squares += off * off;
          ++count;
        }
      }
    }
    T_zone_base = T_zone_base * Pose2{0.0, 0.0, 0.5 * kPi};
    T_odom_base = T_odom_base * Pose2{0.02, 0.0, 0.5 * kPi + radians(1.0)};
  }
  return std::sqrt(squares / count);
}

TEST(ScanRegistrar, KeepsWallsFromSmearingOverFourTurns) {
  EXPECT_GT(smear_m({.register_scans = false}), 0.03);
  EXPECT_LT(smear_m(kOn), 0.004);
}

TEST(ScanRegistrar, TakesWhatTheWallsTellThoughTheyDoNotTellAll) {
  ScanRegistrar registrar(kOn);
  sweep(registrar, {0.2, 0.1, 0.0}, {0.2, 0.1, 0.0}, std::nullopt);
  KnownWalls walls = kWalls;
  walls.seen = {true, false, true, false};
  const Pose2 truth{1.23, 0.13, radians(1.0)}, told{1.2, 0.1, 0.0};
  for (int i = 1; i <= 100; ++i) registrar.move(interpolate({0.2, 0.1, 0.0}, told, 0.01 * i));
  const Sweep result = sweep(registrar, truth, told, walls);
  EXPECT_EQ(result.given, 180u);
  EXPECT_EQ(result.first_after, kOn.max_held_lines);
  const Pose2 found = registrar.T_zone_odom() * told;
  EXPECT_NEAR(found.x_m, truth.x_m, 0.003);
  EXPECT_NEAR(found.yaw_rad, truth.yaw_rad, radians(0.05));
  EXPECT_NEAR(found.y_m, told.y_m, 0.02);
}

TEST(ScanRegistrar, LeavesOdometryAloneWithoutARoom) {
  ScanRegistrar registrar(kOn);
  const Sweep blind = sweep(registrar, {0.2, 0.1, 0.0}, {0.25, 0.1, 0.02}, std::nullopt);
  EXPECT_EQ(blind.first_after, 1) << "nothing to wait for";
  EXPECT_EQ(registrar.T_zone_odom(), Pose2{});
}

TEST(ScanRegistrar, BelievesOdometryRatherThanARoomThatDoesNotFit) {
  ScanRegistrar registrar(kOn);
  sweep(registrar, {}, {}, std::nullopt);
  const KnownWalls elsewhere{.rectangle = {0.4, 1.5, 0.5, 3.0, 3.0}};
  const Sweep result = sweep(registrar, {0.3, 0.1, 0.2}, {0.3, 0.1, 0.2}, elsewhere);
  EXPECT_EQ(result.given, 180u);
  expect_near(registrar.T_zone_odom(), {}, 1e-9, 1e-9);
}

TEST(ScanRegistrar, GivesBackTheLinesOfThePlaceBeforeWhenTheRobotMovesOn) {
  ScanRegistrar registrar(kOn);
  sweep(registrar, {}, {}, std::nullopt);
  const Pose2 second{0.5, 0.0, 0.0}, third{1.0, 0.0, 0.0};
  EXPECT_TRUE(registrar.take(line(1, second, second, radians(-90.0)), kWalls).empty());
  EXPECT_TRUE(registrar.waits());
  const auto ready = registrar.take(line(2, third, third, radians(-90.0)), kWalls);
  ASSERT_EQ(ready.size(), 1u);
  EXPECT_EQ(ready[0].T_odom_base, second);
  EXPECT_EQ(registrar.finish().size(), 1u);
  EXPECT_FALSE(registrar.waits());
}

TEST(ScanRegistrar, CanBeSwitchedOff) {
  ScanRegistrar registrar({.register_scans = false});
  sweep(registrar, {}, {}, std::nullopt);
  sweep(registrar, {0.21, 0.12, 1.57}, {0.2, 0.1, 1.6}, kWalls);
  EXPECT_EQ(registrar.T_zone_odom(), Pose2{});
}

}  // namespace
}  // namespace enfilade::grid_builder
