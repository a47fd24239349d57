// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "components/gridBuilder/node/grid_builder_node.hpp"
#include "tests/support/node_harness.hpp"

namespace enfilade::grid_builder {

/// Plays laser3D, motorControl and topoGraph round one node.
class GridBuilderNodeTest : public testing::Test {
 protected:
  using Harness = NodeHarness<GridBuilderNode, GridBuilderConfig>;

  GridBuilderNodeTest() { set_process_run_id(""); }

  void start(const GridBuilderConfig& config = {}) {
    harness_ = std::make_unique<Harness>("gridBuilder", config);
    changes_ = &harness_->collect(topics::kGridChange);
    hits_ = &harness_->collect(topics::kScanHits);
    harness_->node();
  }

  void mount_laser() {
    TransformList mount;
    mount.transforms.push_back({0, "base_link", "laser", {.x_m = 0.1, .z_m = 0.6}});
    harness_->publish(topics::kTfStatic, mount);
  }

  void tell_zone(std::uint32_t id, double valid_from_s = 0.0) {
    CurrentZone zone;
    zone.zone_id = id;
    zone.valid_from_ns = from_seconds(valid_from_s);
    harness_->publish(topics::kCurrentZone, zone);
    harness_->publish(topics::kTf, TransformList{{{harness_->now_ns(), "map", "odom", {}}}});
  }

  void tell_sweep(SweepPhase phase, double start_s, double end_s = 0.0, std::uint32_t boot = 7) {
    harness_->publish(topics::kMotorState, MotorState{harness_->now_ns(), boot, 1, phase,
                                                      from_seconds(start_s), from_seconds(end_s), false});
  }

  void tell_pose(double stamp_s, const Pose2& T_odom_base = {}, double linear_m_s = 0.0) {
    harness_->publish(topics::kOdom,
                      Odometry{from_seconds(stamp_s), to_transform3(T_odom_base), linear_m_s, 0.0});
  }

  /// One return straight ahead, `range_m` from the base.
  void see(double stamp_s, float range_m = 2.02F) {
    harness_->publish(topics::kPoints,
                      PointCloud{from_seconds(stamp_s), "base_link", {{range_m, 0.01F, 0.61F}}});
  }

  /// Zone 1, sweeping from t = 1 s on, standing at the origin until t = 5 s.
  void start_sweeping() {
    start();
    mount_laser();
    tell_zone(1);
    tell_sweep(SweepPhase::kSweeping, 1.0);
    for (int i = 0; i <= 50; ++i) tell_pose(0.1 * i);
    settle();
  }

  /// Delivers what has been published at this very instant, writer by writer.
  void settle() { harness_->advance_s(0.0); }

  std::unique_ptr<Harness> harness_;
  std::vector<GridChange>* changes_ = nullptr;
  std::vector<ScanHits>* hits_ = nullptr;
};

}  // namespace enfilade::grid_builder
