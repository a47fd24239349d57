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

}  // namespace

void bind(ConfigBinder& c, TopoGraphConfig& config) {
  GraphConfig& graph = config.graph;
  c.group("period", [&](ConfigBinder& group) { bind(group, config.period); });
  c.text("map_file", config.map_file);
  c.flag("resume", config.resume);
  c.number("same_room_iou", graph.fixer.same_room_iou, 0.05, 1.0);
  c.number("inside_room_m", graph.changer.inside_room_m, 0.0, 2.0);
  c.integer("remembered_answers", graph.remembered_answers, 1, 10000);
  c.group("common_door", [&](ConfigBinder& group) { bind(group, graph.fixer.common_door); });
  c.group("door_match", [&](ConfigBinder& group) { bind(group, graph.fixer.face_match); });
  c.group("pose_tracker", [&](ConfigBinder& group) { bind(group, graph.tracker); });
  graph.changer.face_match = graph.fixer.face_match;
}

}  // namespace enfilade::topo_graph
