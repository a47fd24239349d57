// SPDX-License-Identifier: Apache-2.0
#include "components/gridBuilder/node/grid_builder_config.hpp"

namespace enfilade::grid_builder {
namespace {

void bind_grid(ConfigBinder& c, ZoneGridConfig& grid) {
  c.number("resolution_m", grid.resolution_m, 0.01, 1.0);
  c.number("prob_hit", grid.prob_hit, 0.51, 0.99);
  c.number("prob_miss", grid.prob_miss, 0.01, 0.49);
  c.number("clamp_min", grid.clamp_min, 0.001, 0.49);
  c.number("clamp_max", grid.clamp_max, 0.51, 0.999);
  c.number("occupied_from", grid.occupied_from, 0.1, 0.9);
  c.number("max_range_m", grid.max_range_m, 0.5, 100.0);
  c.number("min_height_m", grid.min_height_m, -10.0, 10.0);
  c.number("max_height_m", grid.max_height_m, -10.0, 30.0);
  c.integer("max_memory_mb", grid.max_memory_mb, 1, 65536);
}

void bind_odometry(ConfigBinder& c, OdometryBufferConfig& odometry) {
  c.integer("max_samples", odometry.max_samples, 2, 100000);
  c.number("max_gap_s", odometry.max_gap_s, 0.01, 10.0);
  c.number("still_linear_m_s", odometry.still_linear_m_s, 0.0, 10.0);
  c.number("still_angular_rad_s", odometry.still_angular_rad_s, 0.0, 10.0);
  c.number("fastest_linear_m_s", odometry.fastest_linear_m_s, 0.1, 100.0);
  c.number("fastest_angular_rad_s", odometry.fastest_angular_rad_s, 0.1, 100.0);
}

void bind_drift(ConfigBinder& c, OdometryDriftConfig& d) {
  c.number("distance_sigma", d.distance_sigma, 0.0, 0.5);
  c.number("turn_sigma", d.turn_sigma, 0.0, 0.5);
  c.number("curve_sigma_deg_m", d.curve_sigma_deg_m, 0.0, 45.0);
  c.number("slip_m", d.slip_m, 0.0, 1.0);
  c.number("slip_deg", d.slip_deg, 0.0, 45.0);
  c.number("place_sigma_m", d.place_sigma_m, 0.0001, 1.0);
  c.number("place_sigma_deg", d.place_sigma_deg, 0.001, 45.0);
  c.number("gate_sigma", d.gate_sigma, 0.1, 100.0);
}

void bind_registration(ConfigBinder& c, ScanRegistrarConfig& r) {
  c.number("from_m", r.from_m, 0.0, 10.0);
  c.number("to_m", r.to_m, 0.1, 30.0);
  c.number("first_gate_m", r.first_gate_m, 0.02, 1.0);
  c.number("last_gate_m", r.last_gate_m, 0.01, 0.5);
  c.number("corner_m", r.corner_m, 0.0, 1.0);
  c.number("sigma_m", r.sigma_m, 0.001, 0.2);
  c.number("max_sigma_m", r.max_sigma_m, 0.0001, 0.1);
  c.number("max_sigma_deg", r.max_sigma_deg, 0.001, 5.0);
  c.number("max_wall_sigma_m", r.max_wall_sigma_m, 0.001, 10.0);
  c.number("min_share", r.min_share, 0.0, 1.0);
  c.number("moved_m", r.moved_m, 0.0, 1.0);
  c.number("moved_deg", r.moved_deg, 0.0, 45.0);
  c.integer("max_held_lines", r.max_held_lines, 1, 10000);
  c.group("drift", [&](ConfigBinder& g) { bind_drift(g, r.drift); });
}

void bind_pictures(ConfigBinder& c, PicturePublisherConfig& config) {
  c.number("period_s", config.period_s, 0.0, 3600.0);
  c.number("floor_from_m", config.pictures.floor_from_m, -1.0, 10.0);
  c.number("floor_to_m", config.pictures.floor_to_m, 0.0, 30.0);
  c.integer("max_floor_cells", config.pictures.max_floor_cells, 4, 50'000'000);
}

}  // namespace

void bind(ConfigBinder& c, GridBuilderConfig& config) {
  c.group("period", [&](ConfigBinder& g) { bind(g, config.period); });
  c.flag("stationary", config.gate.stationary);
  c.flag("only_during_sweeps", config.gate.only_during_sweeps);
  c.integer("max_waiting_lines", config.max_waiting_lines, 1, 10000);
  c.group("grid", [&](ConfigBinder& g) { bind_grid(g, config.grid); });
  c.flag("register_scans", config.registration.register_scans);
  c.group("registration", [&](ConfigBinder& g) { bind_registration(g, config.registration); });
  c.group("pictures", [&](ConfigBinder& g) { bind_pictures(g, config.pictures); });
  c.group("odometry", [&](ConfigBinder& g) { bind_odometry(g, config.odometry); });
}

}  // namespace enfilade::grid_builder
