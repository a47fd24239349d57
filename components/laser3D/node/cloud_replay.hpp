// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "components/laser3D/node/laser_3d_config.hpp"
#include "interfaces/runtime/node.hpp"
#include "interfaces/topics/topics.hpp"

namespace enfilade::laser_3d {

/// Plays a point file as if a robot stood where the scanner stood: line after line on rt/points, the
/// scanner's height on rt/tf_static. Begins as soon as somebody listens.
class CloudReplay {
 public:
  CloudReplay(const NodeContext& context, const ReplayConfig& config);

  /// Reads the file. Throws std::runtime_error with one sentence where it cannot be used.
  void start(const Publisher<PointCloud>& points, const Publisher<PointCloud>& points_free,
             const Publisher<TransformList>& tf_static);

 private:
  void step();
  bool may_begin();
  void finish();

  NodeContext context_;
  ReplayConfig config_;
  const Publisher<PointCloud>* points_ = nullptr;
  const Publisher<PointCloud>* points_free_ = nullptr;
  ReplayCloud cloud_;
  std::size_t next_line_ = 0;
  StampNs opened_ns_ = 0;
  bool begun_ = false;
  bool finished_ = false;
};

}  // namespace enfilade::laser_3d
