// SPDX-License-Identifier: Apache-2.0
#include "components/laser3D/node/laser_3d_config.hpp"

namespace enfilade::laser_3d {
namespace {

void bind(ConfigBinder& c, RollInterpolatorConfig& roll) {
  c.integer("history", roll.history, 2, 100000);
  c.number("max_gap_s", roll.max_gap_s, 0.001, 10.0);
}

void bind(ConfigBinder& c, ScanProjectorConfig& projector) {
  c.number("mount_x_m", projector.mount_x_m, -5.0, 5.0);
  c.number("mount_y_m", projector.mount_y_m, -5.0, 5.0);
  c.number("mount_z_m", projector.mount_z_m, 0.0, 5.0);
  c.number("body_radius_m", projector.body_radius_m, 0.0, 5.0);
  c.number("body_height_m", projector.body_height_m, 0.0, 5.0);
  c.number("body_margin_m", projector.body_margin_m, 0.0, 1.0);
  c.number("range_bias_m", projector.range_bias_m, -0.2, 0.2);
  c.number("free_range_m", projector.free_range_m, 0.1, 100.0);
  c.integer("free_run_beams", projector.free_run_beams, 1, 10000);
  c.number("veil_min_jump_m", projector.veil.min_jump_m, 0.01, 10.0);
}

void bind(ConfigBinder& c, FloorEstimatorConfig& floor) {
  c.number("layer_m", floor.layer_m, 0.005, 0.5);
  c.number("cell_m", floor.cell_m, 0.01, 1.0);
  c.number("reach_m", floor.reach_m, 0.5, 100.0);
  c.number("least_below_m", floor.least_below_m, 0.0, 5.0);
  c.number("strong_share", floor.strong_share, 0.01, 1.0);
  c.number("max_tilt_rad", floor.max_tilt_rad, 0.0, 0.5);
}

void bind(ConfigBinder& c, ReplayConfig& replay) {
  c.text("file", replay.file);
  c.number("rate", replay.rate, 0.01, 100.0);
  c.number("line_period_s", replay.line_period_s, 0.001, 1.0);
  c.number("wait_s", replay.wait_s, 0.0, 600.0);
  c.number("floor_drop_m", replay.cloud.floor_drop_m, 0.0, 2.0);
  c.integer("line_points", replay.cloud.line_points, 1, 1000000);
  c.group("floor", [&](ConfigBinder& g) { bind(g, replay.cloud.floor); });
}

}  // namespace

void bind(ConfigBinder& c, Laser3DConfig& config) {
  c.group("period", [&](ConfigBinder& g) { bind(g, config.period); });
  c.choice("driver", config.driver, {{"simulator", DriverKind::kSimulator}, {"replay", DriverKind::kReplay}});
  c.number("scan_silence_s", config.scan_silence_s, 0.05, 60.0);
  c.group("roll", [&](ConfigBinder& g) { bind(g, config.roll); });
  c.group("queue", [&](ConfigBinder& g) { g.integer("capacity", config.queue.capacity, 1, 10000); });
  c.group("projector", [&](ConfigBinder& g) { bind(g, config.projector); });
  c.group("replay", [&](ConfigBinder& g) { bind(g, config.replay); });
}

}  // namespace enfilade::laser_3d
