// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include <gtest/gtest.h>

#include "components/laser3D/core/point_file.hpp"

namespace enfilade::laser_3d {
namespace {

ScannedPoints read_3dtk(const std::string& bytes) { return read_points({"scan.3d", bytes}); }

TEST(ThreeDtkReader, TurnsCentimetresRightUpForwardIntoMetresForwardLeftUp) {
  EXPECT_EQ(read_3dtk("150 -25 300\n").points, (std::vector<Point3f>{{3.0f, -1.5f, -0.25f}}));
}

TEST(ThreeDtkReader, DropsTheSentinelOfNoReturnAndIgnoresFurtherColumns) {
  EXPECT_EQ(read_3dtk("3277 0 0 17\n100 0 0 17\r\n\n0 0 100\n").points,
            (std::vector<Point3f>{{0, -1, 0}, {1, 0, 0}}));
}

TEST(ThreeDtkReader, AnyPrefixGivesTheFirstPointsOrIsRefused) {
  const std::string whole = "150 -25 300\n1e1 2 -3.5\n7 8 9\n";
  const auto all = read_3dtk(whole).points;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    try {
      const auto some = read_3dtk(whole.substr(0, length)).points;
      EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin()));
      EXPECT_EQ(whole[length - 1], '\n') << "a line cut in the middle must not be read";
    } catch (const std::runtime_error&) {
    }
  }
}

TEST(ThreeDtkReader, SaysWhichLineIsWrong) {
  for (const std::string bad : {"1 2\n", "1 two 3\n"}) {
    try {
      read_3dtk("1 2 3\n" + bad);
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).find("scan.3d: line 2: x y z expected"), 0u) << error.what();
    }
  }
}

}  // namespace
}  // namespace enfilade::laser_3d
