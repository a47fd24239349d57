// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "components/laser3D/core/line_queue.hpp"
#include "components/laser3D/core/veil_filter.hpp"

namespace enfilade::laser_3d {

struct ScanProjectorConfig {
  double mount_x_m = 0.10;  ///< the laser's origin in base_link; the roll axis passes through it along x
  double mount_y_m = 0.0;
  double mount_z_m = 0.60;
  double body_radius_m = 0.22;  ///< of the robot's own body, a cylinder that stands on the floor, >= 0
  double body_height_m = 0.40;  ///< >= 0
  double body_margin_m = 0.03;  ///< returns this close to the body are self-hits, >= 0
  double range_bias_m = 0.0;    ///< what the sensor measures too much; taken off every range
  double free_range_m = 8.0;    ///< a run of beams without return shows free space this far, > 0
  int free_run_beams = 8;       ///< a shorter run shows nothing, >= 1
  VeilFilterConfig veil;
};

struct ProjectionDiagnostics {
  std::uint32_t returns = 0;
  std::uint32_t no_return = 0;  ///< +inf
  std::uint32_t invalid = 0;    ///< NaN, -inf, outside the sensor's range
  std::uint32_t self_hits = 0;
  std::uint32_t veil = 0;  ///< split between two surfaces
};

/// One scan line in space, base frame.
struct ProjectedLine {
  std::vector<Point3f> points;     ///< what the beams hit
  std::vector<Point3f> free_ends;  ///< ends of beams that met nothing up to there
  ProjectionDiagnostics diagnostics;
};

/// Turns a scan line and the roll angles of its beams into points.
///
/// A beam at angle a in the scan plane, rolled by φ about the base's x axis, has the direction (cos a, sin a
/// cos φ, sin a sin φ).
class ScanProjector {
 public:
  explicit ScanProjector(const ScanProjectorConfig& config);

  ProjectedLine project(const RolledLine& line) const;

 private:
  bool is_self_hit(const Point3f& p) const;

  ScanProjectorConfig config_;
};

}  // namespace enfilade::laser_3d
