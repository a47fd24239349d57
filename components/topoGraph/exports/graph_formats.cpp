// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/topoGraph/exports/export_parts.hpp"
#include "components/topoGraph/exports/exports.hpp"

namespace enfilade::topo_graph {
namespace {

using Json = nlohmann::ordered_json;
using exports::kind_name;

/// To the micrometre: more digits are noise.
double micro(double value_m) { return std::round(value_m * 1e6) / 1e6; }
Json position(const Point2& p) { return {micro(p.x()), micro(p.y())}; }

Json feature(Json properties, const char* type, Json coordinates) {
  return {{"type", "Feature"},
          {"properties", std::move(properties)},
          {"geometry", {{"type", type}, {"coordinates", std::move(coordinates)}}}};
}

Json room_feature(const Room& room) {
  Json ring = Json::array();
  for (const Point2& p : exports::outline(room)) ring.push_back(position(p));
  ring.push_back(ring.front());
  return feature({{"kind", "room"},
                  {"id", room.id},
                  {"name", exports::room_name(room)},
                  {"width_m", micro(room.width_m)},
                  {"height_m", micro(room.height_m)},
                  {"yaw_rad", micro(room.T_map_room.yaw_rad)}},
                 "Polygon", Json::array({ring}));
}

Json door_feature(const TopologicalMap& map, const Door& door) {
  Json properties{{"kind", kind_name(door.kind)}, {"id", door.id}, {"room", door.face.room}};
  if (door.other_face) properties["other_room"] = door.other_face->room;
  properties["width_m"] = micro(door.face.gap.width_m());
  if (door.height_m) properties["height_m"] = micro(*door.height_m);
  if (door.closed) properties["closed"] = true;
  const Segment face = segment_in_map(*map.find_room(door.face.room), door.face);
  Json line = door.other_face
                  ? Json::array({position(face.midpoint()), position(exports::middle(map, *door.other_face))})
                  : Json::array({position(face.from), position(face.to)});
  return feature(std::move(properties), "LineString", std::move(line));
}

std::string data(const char* key, const std::string& value) {
  return fmt::format("      <data key=\"{}\">{}</data>\n", key, exports::xml(value));
}

std::string number(double value) { return fmt::format("{}", micro(value)); }

std::string room_node(const Room& room) {
  return fmt::format("    <node id=\"room{}\">\n", room.id) + data("kind", "room") +
         data("name", exports::room_name(room)) + data("x_m", number(room.T_map_room.x_m)) +
         data("y_m", number(room.T_map_room.y_m)) + data("yaw_rad", number(room.T_map_room.yaw_rad)) +
         data("width_m", number(room.width_m)) + data("height_m", number(room.height_m)) + "    </node>\n";
}

std::string door_edge(const TopologicalMap& map, const Door& door) {
  std::string out, target;
  if (door.other_face) {
    target = fmt::format("room{}", door.other_face->room);
  } else {
    target = fmt::format("beyond_door{}", door.id);
    const Point2 at = exports::middle(map, door.face);
    out = fmt::format("    <node id=\"{}\">\n", target) + data("kind", std::string(kind_name(door.kind))) +
          data("x_m", number(at.x())) + data("y_m", number(at.y())) + "    </node>\n";
  }
  out += fmt::format("    <edge id=\"door{}\" source=\"room{}\" target=\"{}\">\n", door.id, door.face.room,
                     target);
  out += data("door_kind", std::string(kind_name(door.kind))) +
         data("length_m", number(exports::walk_m(map, door))) +
         data("door_width_m", number(door.face.gap.width_m()));
  if (door.thickness_m) out += data("thickness_m", number(*door.thickness_m));
  if (door.closed) out += data("closed", "true");
  return out + "    </edge>\n";
}

}  // namespace

std::string to_geojson(const TopologicalMap& map) {
  Json features = Json::array();
  for (const Room& room : map.rooms) features.push_back(room_feature(room));
  for (const Door& door : map.doors) features.push_back(door_feature(map, door));
  const Json file{{"type", "FeatureCollection"}, {"features", std::move(features)}};
  return file.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_graphml(const TopologicalMap& map) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graphml "
      "xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n";
  for (const char* key : {"kind", "name"})
    out += fmt::format("  <key id=\"{0}\" for=\"node\" attr.name=\"{0}\" attr.type=\"string\"/>\n", key);
  for (const char* key : {"x_m", "y_m", "yaw_rad", "width_m", "height_m"})
    out += fmt::format("  <key id=\"{0}\" for=\"node\" attr.name=\"{0}\" attr.type=\"double\"/>\n", key);
  out += "  <key id=\"door_kind\" for=\"edge\" attr.name=\"kind\" attr.type=\"string\"/>\n";
  out += "  <key id=\"door_width_m\" for=\"edge\" attr.name=\"width_m\" attr.type=\"double\"/>\n";
  out += "  <key id=\"closed\" for=\"edge\" attr.name=\"closed\" attr.type=\"boolean\"/>\n";
  for (const char* key : {"length_m", "thickness_m"})
    out += fmt::format("  <key id=\"{0}\" for=\"edge\" attr.name=\"{0}\" attr.type=\"double\"/>\n", key);
  out += "  <graph id=\"building\" edgedefault=\"undirected\">\n";
  for (const Room& room : map.rooms) out += room_node(room);
  for (const Door& door : map.doors) out += door_edge(map, door);
  return out + "  </graph>\n</graphml>\n";
}

}  // namespace enfilade::topo_graph
