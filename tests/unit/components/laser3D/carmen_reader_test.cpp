// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/carmen_reader.hpp"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace enfilade::laser_3d {
namespace {

CarmenLog read(const std::string& bytes) { return read_carmen({"robot.log", bytes}); }

const std::string kFrontLaser = "FLASER 3 1 2.5 81.83 10 20 0.5 1 2 0.25 976052857.3 nohost 976052857.4\n";
const std::string kRobotLaser =
    "ROBOTLASER1 0 -1.5 3.0 1.5 30 0.01 0 3 1 0 30.5 1 7 5 6 0.1 4 6 0.2 0 0 0.3 0.4 1e10 1234.5 h 0.2\n";

std::string complaint_about(const std::string& bytes) {
  try {
    read(bytes);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(CarmenReader, ReadsRangesCorrectedPoseAndOdometryOfAFrontLaser) {
  const CarmenLog log = read("# a comment\nPARAM robot_use_laser on\n" + kFrontLaser);
  ASSERT_EQ(log.scans.size(), 1u);
  const CarmenScan& scan = log.scans[0];
  EXPECT_EQ(scan.ranges_m, (std::vector<float>{1.0F, 2.5F, INFINITY}));
  EXPECT_EQ(scan.T_map_laser, (Pose2{10.0, 20.0, 0.5}));
  EXPECT_EQ(scan.T_odom_base, (Pose2{1.0, 2.0, 0.25}));
  EXPECT_DOUBLE_EQ(scan.stamp_s, 976052857.3);
}

TEST(CarmenReader, SpreadsAFrontLaserOverHalfACircleFromRightToLeft) {
  const CarmenScan scan = read(kFrontLaser).scans[0];
  EXPECT_DOUBLE_EQ(scan.first_angle_rad, -0.5 * kPi);
  EXPECT_DOUBLE_EQ(scan.angle_step_rad, 0.5 * kPi);
  const auto even = read("FLASER 2 1 2 0 0 0 0 0 0 1 h 1\n").scans[0];
  EXPECT_DOUBLE_EQ(even.angle_step_rad, 0.5 * kPi) << "180 readings leave the last of 181 out";
}

TEST(CarmenReader, ReadsARobotLaserWithRemissionsAndItsOwnLimits) {
  const CarmenScan scan = read(kRobotLaser).scans.at(0);
  EXPECT_EQ(scan.ranges_m, (std::vector<float>{1.0F, -INFINITY, INFINITY}));
  EXPECT_DOUBLE_EQ(scan.first_angle_rad, -1.5);
  EXPECT_DOUBLE_EQ(scan.angle_step_rad, 1.5);
  EXPECT_EQ(scan.T_map_laser, (Pose2{5.0, 6.0, 0.1}));
  EXPECT_EQ(scan.T_odom_base, (Pose2{4.0, 6.0, 0.2}));
  EXPECT_DOUBLE_EQ(scan.stamp_s, 1234.5);
}

TEST(CarmenReader, ReadsOdometryBetweenTheScans) {
  const CarmenLog log = read("ODOM 1 2 0.5 0 0 0 7.5 h 0.1\r\n" + kFrontLaser);
  ASSERT_EQ(log.odometry.size(), 1u);
  EXPECT_EQ(log.odometry[0].T_odom_base, (Pose2{1.0, 2.0, 0.5}));
  EXPECT_DOUBLE_EQ(log.odometry[0].stamp_s, 7.5);
}

TEST(CarmenReader, PutsReturnsWhereTheCorrectedPoseSays) {
  const auto returns =
      returns_of(read("FLASER 3 1 2 9 10 20 1.5707963267948966 0 0 0 1 h 1\n").scans[0], 5.0);
  ASSERT_EQ(returns.size(), 2u);
  EXPECT_NEAR((returns[0] - Point2(11.0, 20.0)).norm(), 0.0, 1e-9) << "the first reading is on the right";
  EXPECT_NEAR((returns[1] - Point2(10.0, 22.0)).norm(), 0.0, 1e-9);
}

TEST(CarmenReader, AnyPrefixGivesTheFirstScansOrIsRefused) {
  const std::string whole = kFrontLaser + kRobotLaser + kFrontLaser;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const bool is_refused = !complaint_about(whole.substr(0, length)).empty();
    EXPECT_TRUE(is_refused || whole[length - 1] == '\n') << "a line cut in the middle must not be read";
  }
}

TEST(CarmenReader, SaysWhatIsWrongInWhichLine) {
  EXPECT_EQ(
      complaint_about(kFrontLaser + "FLASER 3 1 2\n").find("robot.log: line 2: a range of FLASER is miss"),
      0u);
  EXPECT_EQ(complaint_about("FLASER 3 1 2 x 0 0 0 0 0 0 1\n"),
            "robot.log: line 1: a range of FLASER is no number");
  EXPECT_EQ(complaint_about("FLASER 99999999999 1\n"),
            "robot.log: line 1: the number of ranges of FLASER is more than any scanner has");
  EXPECT_EQ(complaint_about("FLASER 1 1 nan 0 0 0 0 0 1\n"),
            "robot.log: line 1: the pose of the laser of FLASER is out of any reasonable range");
  EXPECT_EQ(complaint_about("FLASER -1 1\n"),
            "robot.log: line 1: the number of ranges of FLASER is no count");
  EXPECT_NE(complaint_about("# nothing\n").find("no FLASER or ROBOTLASER1 line"), std::string::npos);
}

TEST(CarmenReader, KeepsNumbersThatAreNoRangesOutOfTheReturns) {
  const CarmenScan scan = read("FLASER 5 nan inf -inf -3 1e300 0 0 0 0 0 0 1 h 1\n").scans[0];
  EXPECT_TRUE(std::isnan(scan.ranges_m[0]));
  EXPECT_TRUE(returns_of(scan, 1e9).empty());
}

}  // namespace
}  // namespace enfilade::laser_3d
