// SPDX-License-Identifier: Apache-2.0
#include "tools/report/run_recorder.hpp"

#include <gtest/gtest.h>

#include "interfaces/bus/in_process_bus.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::report {
namespace {

struct RunRecorderTest : testing::Test {
  /// Delivers at once.
  static InProcessBus bus_of(InProcessNetwork& network, const std::string& name, int index) {
    return {network, name, index, [](int, const std::function<void()>& work) { work(); }};
  }

  InProcessNetwork network;
  InProcessBus tool = bus_of(network, "enfilade", 0);
  InProcessBus motor = bus_of(network, "motorControl", 1), world = bus_of(network, "simulator", 2);
  RunRecorder recorder{tool, Pose2{}};
  Publisher<Odometry> odom = motor.advertise(topics::kOdom);
  Publisher<GroundTruth> truth = world.advertise(topics::kGroundTruth);
};

TEST_F(RunRecorderTest, KeepsTheLargestErrorOfThePoseWhicheverIsToldFirst) {
  truth.publish({.stamp_ns = 1, .T_world_base = {0.3, 0.0, 0.0}});
  EXPECT_EQ(recorder.record().pose_error_max_m, 0.0) << "nothing to compare with yet";
  odom.publish({.stamp_ns = 1});
  EXPECT_DOUBLE_EQ(recorder.record().pose_error_max_m, 0.3);
  odom.publish({.stamp_ns = 2});
  truth.publish({.stamp_ns = 2, .T_world_base = {0.0, 0.5, 0.0}});
  EXPECT_DOUBLE_EQ(recorder.record().pose_error_max_m, 0.5);
}

}  // namespace
}  // namespace enfilade::report
