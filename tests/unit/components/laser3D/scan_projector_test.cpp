// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/scan_projector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "interfaces/geometry/angles.hpp"

namespace enfilade::laser_3d {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::size_t kBeams = 1081;
const ScanProjectorConfig kConfig{};

struct Room {
  double half_x_m = 2.1, half_y_m = 1.6, height_m = 2.5;

  /// How far the laser sees along a unit direction, by slabs.
  double range_m(double dx, double dy, double dz) const {
    const auto slab = [](double origin, double direction, double low, double high) {
      if (direction == 0.0) return 1e9;
      return ((direction > 0.0 ? high : low) - origin) / direction;
    };
    return std::min({slab(kConfig.mount_x_m, dx, -half_x_m, half_x_m),
                     slab(kConfig.mount_y_m, dy, -half_y_m, half_y_m),
                     slab(kConfig.mount_z_m, dz, 0.0, height_m)});
  }

  /// Distance of a point to the nearest of the room's six faces.
  double distance_m(const Point3f& p) const {
    return std::min({std::abs(half_x_m - std::abs(p.x_m)), std::abs(half_y_m - std::abs(p.y_m)),
                     std::abs(static_cast<double>(p.z_m)), std::abs(height_m - p.z_m)});
  }
};

RolledLine blank_line(float range_m, double roll_rad = 0.0) {
  RolledLine line;
  line.scan.angle_min_rad = static_cast<float>(radians(-135.0));
  line.scan.angle_max_rad = static_cast<float>(radians(135.0));
  line.scan.angle_increment_rad = static_cast<float>(radians(0.25));
  line.scan.range_min_m = 0.1f;
  line.scan.range_max_m = 30.0f;
  line.scan.ranges_m.assign(kBeams, range_m);
  line.roll_rad.assign(kBeams, roll_rad);
  return line;
}

RolledLine line_in(const Room& room, double roll_from_rad, double roll_to_rad) {
  RolledLine line = blank_line(0.0f);
  for (std::size_t i = 0; i < kBeams; ++i) {
    const double a = radians(-135.0 + 0.25 * static_cast<double>(i));
    const double roll = roll_from_rad + (roll_to_rad - roll_from_rad) * static_cast<double>(i) / (kBeams - 1);
    line.roll_rad[i] = roll;
    line.scan.ranges_m[i] = static_cast<float>(
        room.range_m(std::cos(a), std::sin(a) * std::cos(roll), std::sin(a) * std::sin(roll)));
  }
  return line;
}

TEST(ScanProjector, PointsOfARoomLieOnItsFaces) {
  const Room room;
  const ScanProjector projector(kConfig);
  std::size_t seen = 0;
  for (double roll = -kPi / 2; roll < kPi / 2; roll += radians(5.0)) {
    const ProjectedLine line = projector.project(line_in(room, roll, roll + radians(1.0)));
    for (const Point3f& p : line.points) ASSERT_NEAR(room.distance_m(p), 0.0, 1e-4) << roll;
    seen += line.points.size();
    EXPECT_TRUE(line.free_ends.empty());
  }
  EXPECT_GT(seen, 36u * 1000u);
}

TEST(ScanProjector, PositiveRollLiftsTheBeamsToTheLeft) {
  RolledLine line = blank_line(kInfinity, radians(30.0));
  line.scan.ranges_m[900] = 2.0f;  // 90 degrees: left
  const ProjectedLine out = ScanProjector(kConfig).project(line);
  ASSERT_EQ(out.points.size(), 1u);
  EXPECT_NEAR(out.points[0].x_m, 0.10, 1e-5);
  EXPECT_NEAR(out.points[0].y_m, 2.0 * std::cos(radians(30.0)), 1e-5);
  EXPECT_NEAR(out.points[0].z_m, 0.60 + 1.0, 1e-5);
}

TEST(ScanProjector, DropsWhatIsNoMeasurement) {
  RolledLine line = blank_line(2.0f);
  line.scan.ranges_m[10] = std::numeric_limits<float>::quiet_NaN();
  line.scan.ranges_m[20] = -kInfinity;
  line.scan.ranges_m[30] = 0.05f;
  line.scan.ranges_m[40] = 30.5f;
  line.scan.ranges_m[50] = kInfinity;
  const ProjectedLine out = ScanProjector(kConfig).project(line);
  EXPECT_EQ(out.points.size(), kBeams - 5);
  EXPECT_EQ(out.diagnostics.invalid, 4u);
  EXPECT_EQ(out.diagnostics.no_return, 1u);
  EXPECT_TRUE(out.free_ends.empty());
}

TEST(ScanProjector, DropsReturnsFromTheRobotItself) {
  // Rolled by -90°, a beam at 90° points straight down onto the robot's lid: 0.60 - 0.40 m below the laser.
  RolledLine line = blank_line(kInfinity, radians(-90.0));
  line.scan.ranges_m[900] = 0.20f;
  ProjectedLine out = ScanProjector(kConfig).project(line);
  EXPECT_TRUE(out.points.empty());
  EXPECT_EQ(out.diagnostics.self_hits, 1u);
  line.scan.ranges_m[900] = 0.12f;  // a hand over the lid
  out = ScanProjector(kConfig).project(line);
  EXPECT_EQ(out.points.size(), 1u);
}

TEST(ScanProjector, ARunOfBeamsWithoutReturnShowsFreeSpaceAndAShorterOneNothing) {
  const ScanProjector projector(kConfig);
  const auto free_ends_of = [&](std::size_t from, std::size_t beams) {
    RolledLine line = blank_line(2.0f);
    for (std::size_t i = from; i < from + beams; ++i) line.scan.ranges_m[i] = kInfinity;
    return projector.project(line).free_ends;
  };
  EXPECT_TRUE(free_ends_of(500, 7).empty());
  EXPECT_EQ(free_ends_of(500, 8).size(), 8u);
  EXPECT_EQ(free_ends_of(0, 8).size(), 8u);
  EXPECT_EQ(free_ends_of(kBeams - 8, 8).size(), 8u);
  EXPECT_EQ(free_ends_of(0, kBeams).size(), kBeams);
  for (const Point3f& p : free_ends_of(500, 80))
    EXPECT_NEAR(std::hypot(p.x_m - 0.10, p.y_m, p.z_m - 0.60), kConfig.free_range_m, 1e-4);
}

TEST(ScanProjector, AnythingButNoReturnBreaksARun) {
  for (const float breaker : {2.0f, -kInfinity, std::numeric_limits<float>::quiet_NaN(), 0.01f}) {
    RolledLine line = blank_line(2.0f);
    for (std::size_t i = 500; i < 515; ++i) line.scan.ranges_m[i] = kInfinity;
    line.scan.ranges_m[507] = breaker;
    EXPECT_TRUE(ScanProjector(kConfig).project(line).free_ends.empty()) << breaker;
  }
}

}  // namespace
}  // namespace enfilade::laser_3d
