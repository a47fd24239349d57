// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_values.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "components/topoGraph/storage/map_consistency.hpp"
#include "components/topoGraph/storage/map_names.hpp"

namespace enfilade::topo_graph {
namespace {

RectangleCovariance read_covariance(const YamlValue& value) {
  const std::vector<YamlValue> items = value.list();
  RectangleCovariance covariance{};
  if (items.size() != covariance.size()) value.fail("must hold 25 numbers");
  std::transform(items.begin(), items.end(), covariance.begin(),
                 [](const YamlValue& item) { return item.number(); });
  return covariance;
}

Point2 read_point(const YamlValue& value) {
  const std::vector<YamlValue> xy = value.list();
  if (xy.size() != 2) value.fail("a point has two coordinates");
  return {xy[0].number(), xy[1].number()};
}

DoorFace read_face(const YamlValue& value, const TopologicalMap* graph) {
  YamlMap map(value);
  DoorFace face;
  face.room = map.take("room").id();
  face.gap.wall = static_cast<std::uint8_t>(map.take("wall").count(3));
  face.gap.from_m = map.take("from_m").number();
  face.gap.to_m = map.take("to_m").number();
  if (const auto sigma = map.take_if_present("position_sigma_m")) face.position_sigma_m = read_sigma(*sigma);
  if (const auto offset = map.take_if_present("measured_offset_m")) face.measured_offset_m = offset->number();
  map.finish();
  if (!graph) return face;
  if (const auto problem = problem_of(face, *graph)) value.fail(*problem);
  return face;
}

}  // namespace

Pose2 read_pose(const YamlValue& value) {
  YamlMap map(value);
  const Pose2 pose{map.take("x_m").number(), map.take("y_m").number(), map.take("yaw_rad").number()};
  map.finish();
  return pose;
}

double read_size(const YamlValue& value) {
  const double size_m = value.number();
  if (size_m <= 0.0) value.fail("a size must be greater than 0");
  return size_m;
}

Rectangle read_rectangle(const YamlValue& value) {
  YamlMap map(value);
  Rectangle r;
  r.x_m = map.take("x_m").number();
  r.y_m = map.take("y_m").number();
  r.yaw_rad = map.take("yaw_rad").number();
  r.width_m = read_size(map.take("width_m"));
  r.height_m = read_size(map.take("height_m"));
  map.finish();
  return r;
}

WallInterval read_gap(const YamlValue& value) {
  YamlMap map(value);
  WallInterval gap;
  gap.wall = static_cast<std::uint8_t>(map.take("wall").count(3));
  gap.from_m = map.take("from_m").number();
  gap.to_m = map.take("to_m").number();
  map.finish();
  return gap;
}

Room read_room(const YamlValue& value) {
  YamlMap map(value);
  Room room;
  room.id = map.take("id").id();
  room.name = map.take("name").text();
  room.T_map_room = read_pose(map.take("T_map_room"));
  room.width_m = read_size(map.take("width_m"));
  room.height_m = read_size(map.take("height_m"));
  room.zone_id = map.take("zone_id").id();
  room.fixed_ns = map.take("fixed_ns").signed_count();
  if (const auto size = map.take_if_present("measured_size_m")) room.measured_size_m = read_point(*size);
  if (const auto seen = map.take_if_present("seen_ns")) room.seen_ns = seen->signed_count();
  if (const auto pose = map.take_if_present("T_room_base")) room.T_room_base = read_pose(*pose);
  if (const auto place = map.take_if_present("place")) room.place = place->id();
  if (const auto covariance = map.take_if_present("covariance_rad_m"))
    room.covariance = read_covariance(*covariance);
  if (const auto polygon = map.take_if_present("polygon_m")) {
    for (const YamlValue& point : polygon->list()) room.polygon.push_back(read_point(point));
  }
  map.finish();
  return room;
}

Door read_door(const YamlValue& value, const TopologicalMap* graph) {
  YamlMap map(value);
  Door door;
  door.id = map.take("id").id();
  const auto& kinds = names::kDoorKinds;
  const YamlValue kind = map.take("kind");
  door.kind = static_cast<DoorKind>(kind.one_of(kinds.data(), kinds.data() + kinds.size()));
  door.face = read_face(map.take("face"), graph);
  if (const auto other = map.take_if_present("other_face")) door.other_face = read_face(*other, graph);
  if (const auto height = map.take_if_present("height_m")) door.height_m = height->number();
  if (const auto thickness = map.take_if_present("thickness_m")) door.thickness_m = thickness->number();
  if (const auto measured = map.take_if_present("measured_thickness_m"))
    door.measured_thickness_m = measured->number();
  if (const auto driven = map.take_if_present("driven")) door.driven = driven->flag();
  if (const auto closed = map.take_if_present("closed")) door.closed = closed->flag();
  map.finish();
  if (door.kind == DoorKind::kPassage && !door.other_face) kind.fail("a passage has an other_face");
  return door;
}

RoomId read_known_room(const YamlValue& value, const TopologicalMap* graph) {
  if (graph && !graph->find_room(value.id())) value.fail("there is no room " + std::to_string(value.id()));
  return value.id();
}

double read_sigma(const YamlValue& value) {
  const double sigma = value.number();
  if (sigma <= 0.0) value.fail("a standard deviation must be greater than 0");
  return sigma;
}

RoomLink read_link(const YamlValue& value, const TopologicalMap* graph) {
  YamlMap map(value);
  RoomLink link;
  link.from = read_known_room(map.take("from"), graph);
  link.to = read_known_room(map.take("to"), graph);
  link.T_from_to = read_pose(map.take("T_from_to"));
  link.sigma_position_m = read_sigma(map.take("sigma_position_m"));
  link.sigma_yaw_rad = read_sigma(map.take("sigma_yaw_rad"));
  map.finish();
  return link;
}

Place read_place(const YamlValue& value) {
  YamlMap map(value);
  Place place;
  place.id = map.take("id").id();
  place.parent = static_cast<PlaceId>(map.take("parent").count(std::numeric_limits<PlaceId>::max()));
  const auto& kinds = names::kPlaceKinds;
  place.kind = static_cast<PlaceKind>(map.take("kind").one_of(kinds.data(), kinds.data() + kinds.size()));
  place.name = map.take("name").text();
  map.finish();
  return place;
}

}  // namespace enfilade::topo_graph
