// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/core/scan_projector.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace enfilade::laser_3d {
namespace {

Point3f point_on_beam(const ScanProjectorConfig& mount, double angle_rad, double roll_rad, double range_m) {
  const double across_m = range_m * std::sin(angle_rad);
  return {static_cast<float>(mount.mount_x_m + range_m * std::cos(angle_rad)),
          static_cast<float>(mount.mount_y_m + across_m * std::cos(roll_rad)),
          static_cast<float>(mount.mount_z_m + across_m * std::sin(roll_rad))};
}

double beam_angle_rad(const LaserScan& scan, std::size_t beam) {
  return static_cast<double>(scan.angle_min_rad) +
         static_cast<double>(beam) * static_cast<double>(scan.angle_increment_rad);
}

bool is_no_return(float range_m) { return range_m == std::numeric_limits<float>::infinity(); }

}  // namespace

ScanProjector::ScanProjector(const ScanProjectorConfig& config) : config_(config) {
  if (!(config.body_radius_m >= 0.0) || !(config.body_height_m >= 0.0) || !(config.body_margin_m >= 0.0))
    throw std::invalid_argument("projector: the body's measures must not be negative");
  if (!(config.free_range_m > 0.0) || config.free_run_beams < 1)
    throw std::invalid_argument(
        "projector: free_range_m must be greater than 0 and free_run_beams at least 1");
  if (!(config.veil.min_jump_m > 0.0))
    throw std::invalid_argument("projector: veil.min_jump_m must be greater than 0");
}

bool ScanProjector::is_self_hit(const Point3f& p) const {
  return std::hypot(p.x_m, p.y_m) < config_.body_radius_m + config_.body_margin_m &&
         p.z_m < config_.body_height_m + config_.body_margin_m;
}

ProjectedLine ScanProjector::project(const RolledLine& line) const {
  const LaserScan& scan = line.scan;
  const std::size_t beams = scan.ranges_m.size();
  const std::vector<bool> veil = find_veil(scan, config_.veil);
  ProjectedLine out;
  out.points.reserve(beams);
  std::size_t run_from = 0;  // first beam of the run without return that ends here
  const auto end_run = [&](std::size_t run_to) {
    if (run_to - run_from >= static_cast<std::size_t>(config_.free_run_beams))
      for (std::size_t i = run_from; i < run_to; ++i)
        out.free_ends.push_back(
            point_on_beam(config_, beam_angle_rad(scan, i), line.roll_rad[i], config_.free_range_m));
    run_from = run_to + 1;
  };
  for (std::size_t i = 0; i < beams; ++i) {
    const float range_m = scan.ranges_m[i];
    if (is_no_return(range_m)) {
      ++out.diagnostics.no_return;
      continue;
    }
    end_run(i);
    if (!(range_m >= scan.range_min_m && range_m <= scan.range_max_m)) {  // NaN too
      ++out.diagnostics.invalid;
      continue;
    }
    const Point3f p = point_on_beam(config_, beam_angle_rad(scan, i), line.roll_rad[i],
                                    static_cast<double>(range_m) - config_.range_bias_m);
    if (is_self_hit(p)) {
      ++out.diagnostics.self_hits;
    } else if (veil[i]) {
      ++out.diagnostics.veil;
    } else {
      out.points.push_back(p);
    }
  }
  end_run(beams);
  out.diagnostics.returns = static_cast<std::uint32_t>(out.points.size());
  return out;
}

}  // namespace enfilade::laser_3d
