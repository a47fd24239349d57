// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/node/laser_3d_node.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/node_harness.hpp"

namespace enfilade::laser_3d {
namespace {

LaserScan line_at(StampNs stamp_ns, float range_m = 2.0f) {
  LaserScan scan;
  scan.stamp_ns = stamp_ns;
  scan.frame_id = "whatever the driver says";
  scan.angle_min_rad = -2.0f;
  scan.angle_increment_rad = 0.04f;
  scan.time_increment_s = 0.0001f;
  scan.range_min_m = 0.1f;
  scan.range_max_m = 30.0f;
  scan.ranges_m.assign(101, range_m);  // 10 ms long
  return scan;
}

struct Laser {
  NodeHarness<Laser3DNode, Laser3DConfig> harness{"laser3D", Laser3DConfig{}};
  std::vector<LaserScan>& scans = harness.collect(topics::kScan);
  std::vector<PointCloud>& points = harness.collect(topics::kPoints);
  std::vector<PointCloud>& points_free = harness.collect(topics::kPointsFree);
  std::vector<TransformList>& tf = harness.collect(topics::kTf);
  std::vector<TransformList>& tf_static = harness.collect(topics::kTfStatic);

  Laser() { harness.node(); }

  void joint(double time_s, double roll_rad) {
    harness.publish(topics::kJointStates, {.stamp_ns = from_seconds(time_s),
                                           .names = {"left_wheel_joint", kRollJoint},
                                           .positions_rad = {99.0, roll_rad},
                                           .velocities_rad_s = {0.0, 0.0}});
  }
  void settle() { harness.advance_s(0.001); }
};

TEST(Laser3DNode, PublishesALineAsSoonAsItsLastBeamHasItsAngle) {
  Laser laser;
  laser.joint(1.0, 0.5);
  laser.harness.publish(topics::kSimScan, line_at(from_seconds(1.001)));
  laser.joint(1.005, 0.5);
  laser.settle();
  EXPECT_TRUE(laser.points.empty());
  EXPECT_EQ(laser.scans.size(), 1u);
  laser.joint(1.015, 0.5);
  laser.settle();
  ASSERT_EQ(laser.points.size(), 1u);
  EXPECT_EQ(laser.points[0].stamp_ns, from_seconds(1.001));
  EXPECT_EQ(laser.points[0].frame_id, "base_link");
  EXPECT_EQ(laser.points[0].points.size(), 101u);
  EXPECT_TRUE(laser.points_free.empty());
}

TEST(Laser3DNode, FramesSayHowTheScanPlaneLies) {
  Laser laser;
  laser.joint(1.0, 0.5);
  laser.harness.publish(topics::kSimScan, line_at(from_seconds(1.0)));
  laser.joint(1.02, 0.5);
  laser.settle();
  ASSERT_EQ(laser.tf_static.size(), 1u);
  EXPECT_EQ(laser.tf_static[0].transforms[0].frame_id, "base_link");
  EXPECT_EQ(laser.tf_static[0].transforms[0].child_frame_id, "laser");
  EXPECT_EQ(laser.tf_static[0].transforms[0].transform, (Transform3{.x_m = 0.1, .z_m = 0.6}));
  ASSERT_EQ(laser.tf.size(), 1u);
  EXPECT_EQ(laser.tf[0].transforms[0].child_frame_id, laser.scans[0].frame_id);
  EXPECT_NEAR(laser.tf[0].transforms[0].transform.qx, std::sin(0.25), 1e-12);
}

TEST(Laser3DNode, BeamsWithoutReturnGoToPointsFree) {
  Laser laser;
  laser.joint(1.0, 0.5);
  laser.harness.publish(topics::kSimScan, line_at(from_seconds(1.0), std::numeric_limits<float>::infinity()));
  laser.joint(1.02, 0.5);
  laser.settle();
  ASSERT_EQ(laser.points.size(), 1u) << "an empty line is a line";
  EXPECT_TRUE(laser.points[0].points.empty());
  ASSERT_EQ(laser.points_free.size(), 1u);
  EXPECT_EQ(laser.points_free[0].points.size(), 101u);
  EXPECT_EQ(laser.points_free[0].stamp_ns, laser.points[0].stamp_ns);
}

TEST(Laser3DNode, TellsOfLinesWithoutAngles) {
  Laser laser;
  for (int i = 0; i < 25; ++i) laser.harness.publish(topics::kSimScan, line_at(from_seconds(0.025 * i)));
  laser.harness.advance_s(0.2);
  ASSERT_EQ(laser.harness.logged().size(), 1u);
  EXPECT_EQ(laser.harness.logged()[0].text, "5 scan lines dropped: the roll angle was not known for them");
}

TEST(Laser3DNode, SilenceOfTheScannerIsAnEmergencyThatEndsWithTheNextLine) {
  Laser laser;
  laser.harness.advance_s(1.0);
  EXPECT_EQ(laser.harness.component().state(), LifecycleState::kEmergency);
  for (int i = 0; i < 40; ++i) {
    laser.harness.publish(topics::kSimScan, line_at(laser.harness.now_ns()));
    laser.harness.advance_s(0.025);
  }
  EXPECT_EQ(laser.harness.component().state(), LifecycleState::kComputing);
}

}  // namespace
}  // namespace enfilade::laser_3d
