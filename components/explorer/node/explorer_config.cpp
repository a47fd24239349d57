// SPDX-License-Identifier: Apache-2.0
#include "components/explorer/node/explorer_config.hpp"

namespace enfilade::explorer {
namespace {

void bind(ConfigBinder& c, ProjectedGridConfig& grid) {
  c.number("obstacle_from_m", grid.obstacle_from_m, 0.0, 1.0);
  c.number("obstacle_to_m", grid.obstacle_to_m, 0.1, 3.0);
  c.number("seen_below_m", grid.seen_below_m, 0.05, 1.0);
}

void bind(ConfigBinder& c, ExplorationConfig& e) {
  c.number("coarse_step_deg", e.coarse_step_deg, 0.1, 10.0);
  c.number("fine_step_deg", e.fine_step_deg, 0.1, 10.0);
  c.integer("max_sweeps_per_zone", e.max_sweeps_per_zone, 2, 100);
  c.number("widest_door_m", e.widest_door_m, 0.5, 10.0);
  c.number("whole_wall_share", e.whole_wall_share, 0.1, 1.0);
  c.integer("looks_without_room", e.looks_without_room, 1, 100);
  c.number("estimate_wait_s", e.estimate_wait_s, 0.1, 60.0);
  c.number("answer_wait_s", e.answer_wait_s, 0.5, 300.0);
  c.number("retry_s", e.retry_s, 1.0, 3600.0);
  c.number("staging_m", e.staging_m, 0.3, 3.0);
  c.number("staging_search_m", e.staging_search_m, 0.1, 3.0);
  c.integer("door_attempts", e.door_attempts, 1, 20);
  c.integer("door_rounds", e.door_rounds, 1, 10);
  c.number("give_way_m", e.give_way_m, 0.0, 5.0);
  c.number("watch_s", e.watch_s, 0.0, 300.0);
  c.number("outside_m", e.outside_m, 0.1, 2.0);
}

void bind(ConfigBinder& c, SweeperConfig& s) {
  c.number("from_rad", s.from_rad, -3.2, 3.2);
  c.number("to_rad", s.to_rad, -3.2, 3.2);
  c.number("line_rate_hz", s.line_rate_hz, 1.0, 1000.0);
  c.number("repeat_s", s.repeat_s, 0.1, 60.0);
  c.number("spare_s", s.spare_s, 1.0, 300.0);
  c.number("settle_s", s.settle_s, 0.1, 60.0);
  c.integer("max_attempts", s.max_attempts, 1, 100);
}

void bind(ConfigBinder& c, StabilityTestConfig& s) {
  c.number("shift_m", s.shift_m, 0.001, 2.0);
  c.number("angle_deg", s.angle_deg, 0.01, 45.0);
}

void bind(ConfigBinder& c, ViewTargetsConfig& t) {
  c.number("along_step_m", t.along_step_m, 0.02, 1.0);
  c.number("height_step_m", t.height_step_m, 0.02, 1.0);
  c.number("band_from_m", t.band_from_m, 0.0, 3.0);
  c.number("band_to_m", t.band_to_m, 0.1, 3.2);
  c.number("gap_weight", t.gap_weight, 0.0, 100.0);
  c.number("narrowest_gap_m", t.narrowest_gap_m, 0.1, 3.0);
  c.number("floor_step_m", t.floor_step_m, 0.05, 2.0);
  c.number("floor_weight", t.floor_weight, 0.0, 100.0);
  c.number("futility", t.futility, 0.0, 1.0);
}

void bind(ConfigBinder& c, ViewPlannerConfig& v) {
  c.number("lattice_m", v.lattice_m, 0.1, 5.0);
  c.integer("max_places", v.max_places, 1, 10000);
  c.integer("max_targets", v.max_targets, 1, 100000);
  c.number("inside_m", v.inside_m, 0.0, 2.0);
  c.number("sensor_height_m", v.sensor_height_m, 0.0, 3.0);
  c.number("blind_half_angle_deg", v.blind_half_angle_deg, 0.0, 90.0);
  c.number("range_m", v.range_m, 0.5, 100.0);
  c.number("least_gain_m2", v.least_gain_m2, 0.001, 100.0);
  c.number("linear_m_s", v.linear_m_s, 0.01, 5.0);
  c.number("angular_rad_s", v.angular_rad_s, 0.01, 10.0);
  c.number("sweep_s", v.sweep_s, 0.1, 300.0);
}

void bind(ConfigBinder& c, PathPlannerConfig& p) {
  c.number("hard_radius_m", p.hard_radius_m, 0.05, 2.0);
  c.number("narrow_radius_m", p.narrow_radius_m, 0.05, 2.0);
  c.number("soft_radius_m", p.soft_radius_m, 0.06, 3.0);
  c.number("unexplored_radius_m", p.unexplored_radius_m, 0.0, 2.0);
  c.number("soft_cost", p.soft_cost, 0.0, 100.0);
  c.number("escape_m", p.escape_m, 0.0, 3.0);
}

void bind(ConfigBinder& c, PathFollowerConfig& f) {
  c.number("linear_m_s", f.linear_m_s, 0.02, 5.0);
  c.number("angular_rad_s", f.angular_rad_s, 0.05, 10.0);
  c.number("deceleration_m_s2", f.deceleration_m_s2, 0.01, 10.0);
  c.number("look_ahead_m", f.look_ahead_m, 0.05, 3.0);
  c.number("turn_first_rad", f.turn_first_rad, 0.05, 3.2);
  c.number("goal_tolerance_m", f.goal_tolerance_m, 0.005, 1.0);
  c.number("yaw_tolerance_rad", f.yaw_tolerance_rad, 0.002, 1.0);
  c.number("turn_gain", f.turn_gain, 0.1, 20.0);
  c.number("creep_m_s", f.creep_m_s, 0.005, 0.5);
}

void bind(ConfigBinder& c, SafetyGuardConfig& g) {
  c.number("robot_radius_m", g.robot_radius_m, 0.05, 2.0);
  c.number("side_margin_m", g.side_margin_m, 0.0, 1.0);
  c.number("ahead_m", g.ahead_m, 0.0, 2.0);
  c.number("deceleration_m_s2", g.deceleration_m_s2, 0.05, 20.0);
  c.number("latency_s", g.latency_s, 0.0, 2.0);
  c.number("lowest_m", g.lowest_m, -1.0, 3.0);
  c.number("highest_m", g.highest_m, 0.0, 3.0);
}

void bind(ConfigBinder& c, DriveConfig& d) {
  c.group("planner", [&](ConfigBinder& g) { bind(g, d.planner); });
  c.group("follower", [&](ConfigBinder& g) { bind(g, d.follower); });
  c.group("guard", [&](ConfigBinder& g) { bind(g, d.guard); });
  c.number("body_radius_m", d.floor.body_radius_m, 0.0, 2.0);
  c.number("trodden_radius_m", d.floor.trodden_radius_m, 0.0, 2.0);
  c.number("near_clearance_m", d.near_clearance_m, 0.05, 2.0);
  c.number("near_speed_m_s", d.near_speed_m_s, 0.02, 2.0);
  c.number("narrow_speed_m_s", d.narrow_speed_m_s, 0.02, 2.0);
  c.number("open_clearance_m", d.open_clearance_m, 0.1, 5.0);
  c.number("blocked_s", d.blocked_s, 0.1, 300.0);
  c.number("patience_s", d.patience_s, 0.1, 300.0);
  c.integer("max_replans", d.max_replans, 0, 100);
  c.number("slowest_m_s", d.slowest_m_s, 0.001, 1.0);
  c.number("spare_s", d.spare_s, 1.0, 600.0);
}

void bind(ConfigBinder& c, DoorGeometryConfig& g) {
  c.number("max_size_difference_m", g.max_size_difference_m, 0.01, 5.0);
  c.number("max_shift_m", g.max_shift_m, 0.01, 5.0);
  c.number("max_turn_deg", g.max_turn_deg, 0.1, 45.0);
  c.number("same_door_m", g.same_door_m, 0.05, 3.0);
  c.number("new_door_m", g.new_door_m, 0.1, 10.0);
}

void bind(ConfigBinder& c, DoorCorridorConfig& d) {
  c.number("inside_m", d.inside_m, 0.3, 3.0);
  c.number("inside_least_m", d.inside_least_m, 0.2, 3.0);
  c.number("beyond_m", d.beyond_m, 0.3, 3.0);
  c.number("beyond_least_m", d.beyond_least_m, 0.3, 3.0);
  c.number("max_offset_m", d.max_offset_m, 0.0, 1.0);
  c.number("clearance_m", d.clearance_m, 0.1, 1.0);
  c.number("narrow_clearance_m", d.narrow_clearance_m, 0.1, 1.0);
  c.number("enough_m", d.enough_m, 0.1, 2.0);
  c.number("max_unexplored_share", d.max_unexplored_share, 0.0, 1.0);
}

void bind(ConfigBinder& c, DoorJudgeConfig& j) {
  c.integer("exit_beyond_cells", j.exit_beyond_cells, 0, 1000000);
  c.integer("exit_free_cells", j.exit_free_cells, 0, 1000000);
  c.number("beyond_from_m", j.beyond_from_m, 0.0, 10.0);
  c.number("beyond_to_m", j.beyond_to_m, 0.1, 30.0);
  c.number("beyond_side_m", j.beyond_side_m, 0.0, 10.0);
  c.number("floor_clear_m", j.floor_clear_m, 0.0, 1.0);
  c.number("highest_m", j.highest_m, 0.1, 3.2);
  c.group("corridor", [&](ConfigBinder& g) { bind(g, j.corridor); });
}

void bind(ConfigBinder& c, DoorCrossingConfig& x) {
  c.number("linear_m_s", x.linear_m_s, 0.03, 2.0);
  c.number("deceleration_m_s2", x.deceleration_m_s2, 0.01, 10.0);
  c.number("angular_rad_s", x.angular_rad_s, 0.05, 5.0);
  c.number("side_gain_per_m", x.side_gain_per_m, 0.0, 20.0);
  c.number("max_heading_rad", x.max_heading_rad, 0.01, 1.5);
  c.number("turn_gain", x.turn_gain, 0.1, 20.0);
  c.number("blocked_s", x.blocked_s, 0.1, 300.0);
  c.number("timeout_s", x.timeout_s, 1.0, 600.0);
}

}  // namespace

void bind(ConfigBinder& c, ExplorerConfig& config) {
  MachineConfig& m = config.machine;
  c.group("period", [&](ConfigBinder& g) { bind(g, config.period); });
  c.number("odometry_stale_s", config.odometry_stale_s, 0.05, 10.0);
  c.number("points_stale_s", config.points_stale_s, 0.05, 60.0);
  c.number("state_period_s", config.state_period_s, 0.05, 10.0);
  bind(c, m.exploration);
  c.group("grid", [&](ConfigBinder& g) { bind(g, config.grid); });
  c.group("sweep", [&](ConfigBinder& g) { bind(g, m.sweeper); });
  c.group("stability", [&](ConfigBinder& g) { bind(g, m.stability); });
  c.group("targets", [&](ConfigBinder& g) { bind(g, m.targets); });
  c.group("views", [&](ConfigBinder& g) { bind(g, m.views); });
  c.group("drive", [&](ConfigBinder& g) { bind(g, m.drive); });
  c.group("geometry", [&](ConfigBinder& g) { bind(g, m.geometry); });
  c.group("judge", [&](ConfigBinder& g) { bind(g, m.judge); });
  c.group("crossing", [&](ConfigBinder& g) { bind(g, m.crossing); });
}

}  // namespace enfilade::explorer
