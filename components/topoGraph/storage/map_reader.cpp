// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <utility>

#include "components/topoGraph/storage/map_file.hpp"
#include "components/topoGraph/storage/map_names.hpp"
#include "components/topoGraph/storage/yaml_reader.hpp"

namespace enfilade::topo_graph {
namespace {

constexpr double kWallSlackM = 1e-6;

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

DoorFace read_face(const YamlValue& value, const TopologicalMap& graph) {
  YamlMap map(value);
  DoorFace face;
  face.room = map.take("room").id();
  face.gap.wall = static_cast<std::uint8_t>(map.take("wall").count(3));
  face.gap.from_m = map.take("from_m").number();
  face.gap.to_m = map.take("to_m").number();
  if (const auto sigma = map.take_if_present("position_sigma_m")) face.position_sigma_m = sigma->number();
  if (const auto offset = map.take_if_present("measured_offset_m")) face.measured_offset_m = offset->number();
  map.finish();
  const Room* room = graph.find_room(face.room);
  if (!room) value.fail("there is no room " + std::to_string(face.room));
  const double length_m = room->rectangle().wall_length_m(face.gap.wall);
  const bool on_wall = face.gap.from_m >= -kWallSlackM && face.gap.from_m < face.gap.to_m &&
                       face.gap.to_m <= length_m + kWallSlackM;
  if (!on_wall)
    value.fail("the gap does not lie on its wall, which is " + std::to_string(length_m) + " m long");
  return face;
}

Door read_door(const YamlValue& value, const TopologicalMap& graph) {
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
  if (const auto driven = map.take_if_present("driven")) door.driven = driven->flag();
  map.finish();
  if (door.kind == DoorKind::kPassage && !door.other_face) kind.fail("a passage has an other_face");
  return door;
}

RoomId read_known_room(const YamlValue& value, const TopologicalMap& graph) {
  if (!graph.find_room(value.id())) value.fail("there is no room " + std::to_string(value.id()));
  return value.id();
}

double read_sigma(const YamlValue& value) {
  const double sigma = value.number();
  if (sigma <= 0.0) value.fail("a standard deviation must be greater than 0");
  return sigma;
}

RoomLink read_link(const YamlValue& value, const TopologicalMap& graph) {
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

Answer read_answer(const YamlValue& value) {
  YamlMap map(value);
  Answer answer;
  answer.call.client = map.take("client").text();
  answer.call.number = map.take("number").count(std::numeric_limits<std::uint64_t>::max());
  const auto& kinds = names::kRequestKinds;
  answer.kind =
      static_cast<RequestKind>(map.take("request").one_of(kinds.data(), kinds.data() + kinds.size()));
  answer.accepted = map.take("accepted").flag();
  answer.message = map.take("message").text();
  answer.id = static_cast<std::uint32_t>(map.take("id").count(std::numeric_limits<std::uint32_t>::max()));
  map.finish();
  return answer;
}

std::optional<std::uint32_t> read_room_id(YamlMap& map, const char* key, const TopologicalMap& graph) {
  const auto value = map.take_if_present(key);
  if (!value) return std::nullopt;
  return read_known_room(*value, graph);
}

CurrentZone read_zone(YamlMap& map, const TopologicalMap& graph) {
  CurrentZone zone;
  zone.zone_id = map.take("zone_id").id();
  zone.room = read_room_id(map, "room", graph);
  zone.from_room = read_room_id(map, "from_room", graph);
  if (const auto door = map.take_if_present("via_door")) {
    zone.via_door = door->id();
    if (!graph.find_door(*zone.via_door)) door->fail("there is no door " + std::to_string(*zone.via_door));
  }
  zone.T_map_zone = read_pose(map.take("T_map_zone"));
  if (const auto located = map.take_if_present("located")) zone.located = located->flag();
  zone.valid_from_ns = map.take("valid_from_ns").signed_count();
  return zone;
}

template <class Item>
std::uint32_t read_last_id(const YamlValue& value, const std::vector<Item>& items) {
  const auto last = static_cast<std::uint32_t>(value.count(std::numeric_limits<std::uint32_t>::max()));
  if (!items.empty() && last < items.back().id) value.fail("is less than an id in use");
  return last;
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

LoopClosure read_closure(const YamlValue& value, const TopologicalMap& graph) {
  YamlMap map(value);
  LoopClosure closure;
  const YamlValue door = map.take("door");
  closure.door = door.id();
  if (!graph.find_door(closure.door)) door.fail("there is no door " + std::to_string(closure.door));
  closure.room = read_known_room(map.take("room"), graph);
  closure.link.from = read_known_room(map.take("from"), graph);
  closure.link.T_from_to = read_pose(map.take("T_from_to"));
  closure.link.sigma_position_m = read_sigma(map.take("sigma_position_m"));
  closure.link.sigma_yaw_rad = read_sigma(map.take("sigma_yaw_rad"));
  closure.entrance = read_gap(map.take("entrance"));
  for (const YamlValue& gap : map.take("gaps").list()) closure.gaps.push_back(read_gap(gap));
  for (const YamlValue& added : map.take("added").list()) closure.added.push_back(added.id());
  closure.instead = read_room(map.take("instead"));
  closure.instead.id = 0;
  map.finish();
  return closure;
}

Session read_session(const YamlValue& value, const TopologicalMap& graph) {
  YamlMap map(value);
  Session session;
  session.zone = read_zone(map, graph);
  const auto reference = map.take_if_present("reference");
  if (reference) session.reference = read_rectangle(*reference);
  if (session.reference && !session.zone.room)
    reference->fail("there is no room in this zone to be compared with");
  session.reference_ns = map.take("reference_ns").signed_count();
  if (const auto boot = map.take_if_present("odom_boot")) {
    session.odom_boot = static_cast<std::uint32_t>(boot->count(std::numeric_limits<std::uint32_t>::max()));
  }
  if (const auto pose = map.take_if_present("T_zone_base")) session.T_zone_base = read_pose(*pose);
  if (const auto closures = map.take_if_present("closures"))
    for (const YamlValue& closure : closures->list())
      session.closures.push_back(read_closure(closure, graph));
  session.last_room = read_last_id(map.take("last_room"), graph.rooms);
  session.last_door = read_last_id(map.take("last_door"), graph.doors);
  for (const YamlValue& answer : map.take("answers").list()) session.answers.push_back(read_answer(answer));
  map.finish();
  return session;
}

template <class Item>
void append(std::vector<Item>& items, Item item, const YamlValue& value) {
  if (!items.empty() && item.id <= items.back().id) value.fail("ids must grow from one entry to the next");
  items.push_back(std::move(item));
}

void check_frame(const std::string& text, const std::string& name) {
  const auto line =
      std::to_string(std::count(text.begin(), text.end(), '\n') + (text.ends_with('\n') ? 0 : 1));
  if (text.ends_with("\n" + std::string(names::kEnd))) return;
  throw MapFileError(name + ":" + (text.empty() ? "1" : line) +
                     ": the file does not end with \"end: enfilade-map\", so it was cut off or is "
                     "no map; take an older copy of the file");
}

MapFile read_file(const YAML::Node& root, const std::string& name) {
  YamlMap map(YamlValue(root, name, "the file"));
  const YamlValue format = map.take("format");
  if (format.text() != names::kFormat) format.fail("is not " + std::string(names::kFormat));
  const YamlValue version = map.take("version");
  if (version.text() != std::to_string(names::kVersion)) {
    version.fail("this program reads version " + std::to_string(names::kVersion) + " only");
  }
  MapFile file;
  file.map.version = map.take("changes").count(std::numeric_limits<std::uint64_t>::max());
  file.map.stamp_ns = map.take("stamp_ns").signed_count();
  for (const YamlValue& room : map.take("rooms").list()) append(file.map.rooms, read_room(room), room);
  for (const YamlValue& door : map.take("doors").list())
    append(file.map.doors, read_door(door, file.map), door);
  if (const auto links = map.take_if_present("links"))
    for (const YamlValue& link : links->list()) file.map.links.push_back(read_link(link, file.map));
  if (const auto places = map.take_if_present("places"))
    for (const YamlValue& place : places->list()) append(file.map.places, read_place(place), place);
  if (const auto session = map.take_if_present("session")) file.session = read_session(*session, file.map);
  map.take("end");
  map.finish();
  return file;
}

}  // namespace

MapFile parse_map_file(const std::string& text, const std::string& name) {
  check_frame(text, name);
  try {
    return read_file(YAML::Load(text), name);
  } catch (const YAML::Exception& error) {
    throw MapFileError(name + ":" + std::to_string(error.mark.line + 1) + ": " + error.msg +
                       "; mend the line or take an older copy of the file");
  }
}

}  // namespace enfilade::topo_graph
