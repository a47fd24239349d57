// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "components/laser3D/node/cloud_replay.hpp"
#include "components/laser3D/node/laser_3d_config.hpp"
#include "components/laser3D/node/scan_driver.hpp"
#include "interfaces/runtime/node.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::laser_3d {

/// Owns the range sensor. A line is published as points as soon as the joint has been sampled at or after its
/// last beam.
class Laser3DNode : public Node {
 public:
  Laser3DNode(const NodeContext& context, const Laser3DConfig& config);

  void initialize() override;
  void compute() override;
  void emergency() override;

 private:
  void start_scanning();
  void take(const LaserScan& line);
  void take(const JointStates& joints);
  void publish_ready_lines();
  void publish(const RolledLine& line);
  bool scans_silent();
  void warn_of_dropped_lines();

  NodeContext context_;
  Laser3DConfig config_;
  RollInterpolator roll_;
  LineQueue queue_;
  ScanProjector projector_;
  std::unique_ptr<ScanDriver> driver_;  ///< null in a replay
  std::unique_ptr<CloudReplay> replay_;

  Publisher<LaserScan> scan_;
  Publisher<PointCloud> points_;
  Publisher<PointCloud> points_free_;
  Publisher<TransformList> tf_;
  Publisher<TransformList> tf_static_;

  std::optional<StampNs> heard_ns_;  ///< node's clock at the last line; at first, at the first compute()
  std::uint64_t dropped_told_ = 0;
};

}  // namespace enfilade::laser_3d
