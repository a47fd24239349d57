// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/node/topo_graph_config.hpp"

namespace enfilade::topo_graph {
namespace {

void bind(ConfigBinder& c, CommonDoorConfig& config) {
  c.choice("door_faces", config.door_faces,
           {{"paper", DoorFaces::kPaper}, {"thickness", DoorFaces::kThickness}});
  c.number("max_thickness_m", config.max_thickness_m, 0.0, 2.0);
  c.number("max_rotation_rad", config.max_rotation_rad, 0.0, 0.5);
  c.number("max_distance_m", config.max_distance_m, 0.05, 5.0);
  c.number("max_angle_rad", config.max_angle_rad, 0.01, 1.0);
  c.number("max_width_difference_m", config.max_width_difference_m, 0.05, 5.0);
}

void bind(ConfigBinder& c, FaceMatchConfig& config) {
  c.number("max_distance_m", config.max_distance_m, 0.05, 5.0);
  c.number("max_angle_rad", config.max_angle_rad, 0.01, 1.0);
}

void bind(ConfigBinder& c, PoseTrackerConfig& config) {
  c.number("max_size_difference_m", config.max_size_difference_m, 0.0, 2.0);
  c.number("max_shift_m", config.max_shift_m, 0.01, 5.0);
  c.number("max_turn_rad", config.max_turn_rad, 0.001, 0.75);
  c.number("min_shift_m", config.min_shift_m, 0.0, 0.5);
  c.number("min_turn_rad", config.min_turn_rad, 0.0, 0.1);
}

void bind(ConfigBinder& c, UncertaintyConfig& config) {
  c.number("size_m", config.size_m, 0.001, 1.0);
  c.number("door_position_m", config.door_position_m, 0.001, 1.0);
  c.number("door_unseen_m", config.door_unseen_m, 0.001, 5.0);
  c.number("door_direction_rad", config.door_direction_rad, 0.0001, 0.5);
  c.number("thickness_m", config.thickness_m, 0.0, 2.0);
  c.number("thickness_sigma_m", config.thickness_sigma_m, 0.001, 2.0);
  c.number("thickness_spread_m", config.thickness_spread_m, 0.0, 2.0);
  c.number("crossing_sigma_m", config.crossing_sigma_m, 0.001, 2.0);
  c.number("odometry_share", config.odometry_share, 0.0, 0.5);
  c.number("odometry_m", config.odometry_m, 0.001, 1.0);
  c.number("odometry_yaw_rad", config.odometry_yaw_rad, 0.0001, 1.0);
}

void bind(ConfigBinder& c, LoopCloserConfig& config) {
  c.number("gate_sigma", config.gate_sigma, 1.0, 10.0);
  c.number("accept_nats", config.accept_nats, 0.0, 100.0);
  c.number("margin_nats", config.margin_nats, 0.0, 100.0);
  c.number("space_m2", config.space_m2, 1.0, 1e6);
  c.number("door_match_m", config.door_match_m, 0.05, 2.0);
  c.number("open_door_nats", config.open_door_nats, 0.0, 100.0);
  c.number("extra_door_nats", config.extra_door_nats, 0.0, 100.0);
  c.number("missing_door_nats", config.missing_door_nats, 0.0, 100.0);
  c.number("overlap_iou", config.overlap_iou, 0.05, 1.0);
  c.number("other_size_nats", config.other_size_nats, 0.0, 100.0);
  c.number("search_m", config.search_m, 1.0, 1000.0);
}

void bind(ConfigBinder& c, MapMinimiserConfig& config) {
  c.choice("solver", config.solver.solver, {{"ceres", SolverKind::kCeres}, {"sgd", SolverKind::kSgd}});
  c.choice("error", config.solver.error,
           {{"paper", DoorError::kPaper}, {"thickness", DoorError::kThickness}});
  c.number("cauchy_scale", config.solver.cauchy_scale, 0.1, 100.0);
  c.integer("max_iterations", config.solver.max_iterations, 1, 10000);
  c.number("tolerance", config.solver.tolerance, 1e-12, 1.0);
  c.integer("sgd_iterations", config.solver.sgd_iterations, 1, 100000);
  c.number("withdraw_nats", config.withdraw_nats, 0.0, 1000.0);
  c.number("withdraw_weight", config.withdraw_weight, 0.0, 0.99);
}

void bind(ConfigBinder& c, MetricMapPublisherConfig& config) {
  c.number("resolution_m", config.resolution_m, 0.0, 5.0);
  c.integer("max_cells", config.max_cells, 1, 50'000'000);
}

void bind(ConfigBinder& c, LocaliserConfig& config) {
  c.number("size_sigma_m", config.size_sigma_m, 0.005, 1.0);
  c.number("door_sigma_m", config.door_sigma_m, 0.01, 2.0);
  c.number("missing_door_nats", config.missing_door_nats, 0.0, 100.0);
  c.number("motion_sigma_m", config.motion_sigma_m, 0.01, 10.0);
  c.number("motion_share", config.motion_share, 0.0, 1.0);
  c.number("motion_sigma_rad", config.motion_sigma_rad, 0.001, 1.0);
  c.number("elsewhere_nats", config.elsewhere_nats, 1.0, 100.0);
  c.number("certain", config.certain, 0.51, 0.9999);
}

}  // namespace

void bind(ConfigBinder& c, TopoGraphConfig& config) {
  GraphConfig& graph = config.graph;
  c.group("period", [&](ConfigBinder& group) { bind(group, config.period); });
  c.text("map_file", config.map_file);
  c.integer("journal_kib", config.journal_kib, 1, 65536);
  c.flag("resume", config.resume);
  c.flag("locate", config.locate);
  c.number("estimate_period_s", config.estimate_period_s, 0.0, 60.0);
  c.group("metric_map", [&](ConfigBinder& group) { bind(group, config.metric_map); });
  c.number("inside_room_m", graph.changer.inside_room_m, 0.0, 2.0);
  c.integer("remembered_answers", graph.remembered_answers, 1, 10000);
  c.group("common_door", [&](ConfigBinder& group) { bind(group, graph.fixer.common_door); });
  c.group("door_match", [&](ConfigBinder& group) { bind(group, graph.fixer.face_match); });
  c.group("pose_tracker", [&](ConfigBinder& group) { bind(group, graph.tracker); });
  c.group("uncertainty", [&](ConfigBinder& group) { bind(group, graph.fixer.uncertainty); });
  c.group("loop_closing", [&](ConfigBinder& group) {
    bind(group, graph.fixer.loop_closer);
    group.number("review_unexplored_share", graph.review_unexplored_share, 0.0, 1.0);
    group.integer("review_misfits", graph.review_misfits, 1, 1000);
  });
  c.group("localisation", [&](ConfigBinder& group) { bind(group, graph.localiser); });
  c.group("minimisation", [&](ConfigBinder& group) { bind(group, graph.minimiser); });
  graph.changer.face_match = graph.fixer.face_match;
}

}  // namespace enfilade::topo_graph
