// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "components/gridBuilder/core/zone_grid.hpp"
#include "components/laser3D/core/scan_projector.hpp"
#include "tools/simulator/core/range_finder.hpp"
#include "tools/simulator/core/traffic.hpp"

namespace enfilade::evaluate {

struct RollingScannerConfig {
  double line_step_deg = 1.0;  ///< of roll, from one line to the next
  simulator::RangeFinderConfig laser;
  laser_3d::ScanProjectorConfig projector;
};

/// The simulated laser on its roll motor, and laser3D's projection of its lines.
class RollingScanner {
 public:
  RollingScanner(const simulator::World& world, const RollingScannerConfig& config, std::uint64_t seed);

  /// Lines of one stroke from -90° to +90°, in the base frame.
  std::vector<laser_3d::ProjectedLine> sweep(const Pose2& T_world_base);
  const simulator::RayScene& scene() const { return scene_; }

 private:
  RollingScannerConfig config_;
  simulator::RayScene scene_;
  simulator::RangeFinder laser_;
  simulator::Traffic traffic_;
  laser_3d::ScanProjector projector_;
  simulator::Random random_;
  StampNs now_ns_ = 0;
};

/// gridBuilder's grid and the messages it would publish.
class ZoneRecorder {
 public:
  struct Line {
    GridChange change;
    ScanHits hits;
  };

  explicit ZoneRecorder(const grid_builder::ZoneGridConfig& config) : grid_(config) {}
  Line insert(const laser_3d::ProjectedLine& line, const Point3f& origin_base, const Pose2& T_zone_base);

 private:
  grid_builder::ZoneGrid grid_;
  std::uint64_t sequence_ = 0;
};

}  // namespace enfilade::evaluate
