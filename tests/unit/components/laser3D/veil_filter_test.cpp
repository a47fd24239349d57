// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/veil_filter.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "interfaces/geometry/angles.hpp"

namespace enfilade::laser_3d {
namespace {

/// 1081 beams over 270°, range by angle.
LaserScan scan_of(const std::function<double(double angle_rad)>& range_m) {
  LaserScan scan;
  for (int i = 0; i < 1081; ++i)
    scan.ranges_m.push_back(static_cast<float>(range_m(radians(-135.0 + 0.25 * i))));
  return scan;
}

std::ptrdiff_t veiled(const LaserScan& scan) {
  const auto veil = find_veil(scan, {});
  return std::count(veil.begin(), veil.end(), true);
}

/// A box 1 m wide and 1 m away in front of a wall 3 m away.
double box_before_wall(double angle_rad) {
  return (std::abs(angle_rad) < 0.5 ? 1.0 : 3.0) / std::max(0.2, std::cos(angle_rad));
}

TEST(VeilFilter, DropsAReturnBetweenTwoSurfacesAndNothingElse) {
  LaserScan scan = scan_of(box_before_wall);
  EXPECT_EQ(veiled(scan), 0);
  const auto edge = static_cast<std::size_t>(std::lround((135.0 - degrees(0.5)) / 0.25));
  scan.ranges_m[edge] = 1.9F;
  const auto veil = find_veil(scan, {});
  EXPECT_TRUE(veil[edge]);
  EXPECT_EQ(veiled(scan), 1);
}

TEST(VeilFilter, KeepsAWallSeenAtAGrazingAngle) {
  const LaserScan corridor =
      scan_of([](double a) { return std::min(28.0, 0.9 / std::max(1e-3, std::abs(std::sin(a)))); });
  EXPECT_EQ(veiled(corridor), 0);
}

TEST(VeilFilter, KeepsAThinPoleOfTwoBeamsAndALoneReturnInTheOpen) {
  LaserScan scan = scan_of([](double) { return 5.0; });
  scan.ranges_m[300] = scan.ranges_m[301] = 2.0F;
  EXPECT_EQ(veiled(scan), 0);
  LaserScan open = scan_of([](double) { return std::numeric_limits<double>::infinity(); });
  open.ranges_m[300] = 2.0F;
  EXPECT_EQ(veiled(open), 0);
}

TEST(VeilFilter, NoScanIsNoVeil) { EXPECT_TRUE(find_veil(LaserScan{}, {}).empty()); }

}  // namespace
}  // namespace enfilade::laser_3d
