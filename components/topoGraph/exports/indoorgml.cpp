// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>

#include "components/topoGraph/exports/export_parts.hpp"
#include "components/topoGraph/exports/exports.hpp"

namespace enfilade::topo_graph {
namespace {

/// To the micrometre.
std::string gml_coordinates(const Point2& p) {
  return fmt::format("{} {}", std::round(p.x() * 1e6) / 1e6, std::round(p.y() * 1e6) / 1e6);
}

std::string gml_pos(const Point2& p) { return "<gml:pos>" + gml_coordinates(p) + "</gml:pos>"; }

/// Coordinates are local, in metres: no reference system has a name for them, and without srsName GML forbids
/// axisLabels and uomLabels.
constexpr const char* kPlanar = "srsDimension=\"2\"";

std::string gml_bounds(const TopologicalMap& map) {
  if (map.rooms.empty()) return "";
  Point2 low = map.rooms.front().T_map_room.translation(), high = low;
  for (const Room& room : map.rooms)
    for (const Point2& p : exports::outline(room)) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return fmt::format(
      "  <gml:boundedBy><gml:Envelope {}><gml:lowerCorner>{}</gml:lowerCorner>"
      "<gml:upperCorner>{}</gml:upperCorner></gml:Envelope></gml:boundedBy>\n",
      kPlanar, gml_coordinates(low), gml_coordinates(high));
}

std::string gml_line(const std::string& id, const std::vector<Point2>& points) {
  std::string out = fmt::format("<gml:LineString gml:id=\"{}\" {}>", id, kPlanar);
  for (const Point2& p : points) out += gml_pos(p);
  return out + "</gml:LineString>";
}

bool is_transition(const Door& door) { return door.kind == DoorKind::kPassage && door.other_face; }

/// The doors of `room` that are transitions, one line each.
template <class Line>
std::string for_transitions(const TopologicalMap& map, const Room& room, Line&& line) {
  std::string out;
  for (const Door& door : map.doors)
    if (is_transition(door) && TopologicalMap::find_face(door, room.id)) out += line(door);
  return out;
}

std::string cell_space(const TopologicalMap& map, const Room& room) {
  std::string ring;
  const std::vector<Point2> outline = exports::outline(room);
  for (const Point2& p : outline) ring += gml_pos(p);
  ring += gml_pos(outline.front());
  return fmt::format(
             "      <cellSpaceMember>\n       <CellSpace gml:id=\"cell{0}\">\n"
             "        <gml:name>{1}</gml:name>\n"
             "        <cellSpaceGeometry><Geometry2D><gml:Polygon "
             "gml:id=\"polygon{0}\" {3}><gml:exterior>"
             "<gml:LinearRing>{2}</gml:LinearRing></gml:exterior></gml:Polygon></Geometry2D>"
             "</cellSpaceGeometry>\n        <duality xlink:href=\"#state{0}\"/>\n",
             room.id, exports::xml(exports::room_name(room)), ring, kPlanar) +
         for_transitions(map, room,
                         [](const Door& door) {
                           return fmt::format("        <partialboundedBy xlink:href=\"#boundary{}\"/>\n",
                                              door.id);
                         }) +
         "       </CellSpace>\n      </cellSpaceMember>\n";
}

std::string boundary(const TopologicalMap& map, const Door& door) {
  const Segment face = segment_in_map(*map.find_room(door.face.room), door.face);
  return fmt::format(
      "      <cellSpaceBoundaryMember>\n       <CellSpaceBoundary gml:id=\"boundary{0}\">\n"
      "        <duality xlink:href=\"#transition{0}\"/>\n"
      "        <cellSpaceBoundaryGeometry><geometry2D>{1}</geometry2D>"
      "</cellSpaceBoundaryGeometry>\n       </CellSpaceBoundary>\n      "
      "</cellSpaceBoundaryMember>\n",
      door.id, gml_line(fmt::format("opening{}", door.id), {face.from, face.to}));
}

std::string state(const TopologicalMap& map, const Room& room) {
  return fmt::format(
             "         <stateMember>\n          <State gml:id=\"state{0}\">\n"
             "           <gml:name>{1}</gml:name>\n           <duality xlink:href=\"#cell{0}\"/>\n",
             room.id, exports::xml(exports::room_name(room))) +
         for_transitions(map, room,
                         [](const Door& door) {
                           return fmt::format("           <connects xlink:href=\"#transition{}\"/>\n",
                                              door.id);
                         }) +
         fmt::format(
             "           <geometry><gml:Point gml:id=\"point{}\" {}>{}</gml:Point></geometry>\n"
             "          </State>\n         </stateMember>\n",
             room.id, kPlanar, gml_pos(room.T_map_room.translation()));
}

std::string transition(const TopologicalMap& map, const Door& door) {
  const RoomId a = door.face.room, b = door.other_face->room;
  const std::string way =
      gml_line(fmt::format("way{}", door.id),
               {map.find_room(a)->T_map_room.translation(), exports::middle(map, door.face),
                exports::middle(map, *door.other_face), map.find_room(b)->T_map_room.translation()});
  return fmt::format(
      "         <transitionMember>\n          <Transition gml:id=\"transition{0}\">\n"
      "           <gml:name>door {0}</gml:name>\n           <weight>{1:.6f}</weight>\n"
      "           <connects xlink:href=\"#state{2}\"/>\n           <connects "
      "xlink:href=\"#state{3}\"/>\n"
      "           <duality xlink:href=\"#boundary{0}\"/>\n           "
      "<geometry>{4}</geometry>\n"
      "          </Transition>\n         </transitionMember>\n",
      door.id, exports::walk_m(map, door), a, b, way);
}

std::string primal_space(const TopologicalMap& map) {
  std::string out = "  <primalSpaceFeatures>\n    <PrimalSpaceFeatures gml:id=\"primal\">\n";
  for (const Room& room : map.rooms) out += cell_space(map, room);
  for (const Door& door : map.doors)
    if (is_transition(door)) out += boundary(map, door);
  return out + "    </PrimalSpaceFeatures>\n  </primalSpaceFeatures>\n";
}

std::string space_layer(const TopologicalMap& map) {
  std::string states, transitions;
  for (const Room& room : map.rooms) states += state(map, room);
  for (const Door& door : map.doors)
    if (is_transition(door)) transitions += transition(map, door);
  std::string out = "        <nodes gml:id=\"nodes\">\n" + states + "        </nodes>\n";
  if (!transitions.empty()) out += "        <edges gml:id=\"edges\">\n" + transitions + "        </edges>\n";
  return out;
}

std::string gml_graph(const TopologicalMap& map) {
  if (map.rooms.empty()) return "";  // a layer has at least one state
  return "  <multiLayeredGraph>\n    <MultiLayeredGraph gml:id=\"graph\">\n"
         "     <spaceLayers gml:id=\"layers\">\n      <spaceLayerMember>\n"
         "       <SpaceLayer gml:id=\"rooms\">\n" +
         space_layer(map) +
         "       </SpaceLayer>\n      </spaceLayerMember>\n     </spaceLayers>\n"
         "    </MultiLayeredGraph>\n  </multiLayeredGraph>\n";
}

}  // namespace

std::string to_indoorgml(const TopologicalMap& map) {
  // No prefix before the names of IndoorGML: OGC's own conformance test asks for a root called just so.
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<IndoorFeatures gml:id=\"building\" xmlns=\"http://www.opengis.net/indoorgml/1.0/core\" "
         "xmlns:gml=\"http://www.opengis.net/gml/3.2\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
         "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
         "xsi:schemaLocation=\"http://www.opengis.net/indoorgml/1.0/core "
         "http://schemas.opengis.net/indoorgml/1.0/indoorgmlcore.xsd\">\n" +
         gml_bounds(map) + primal_space(map) + gml_graph(map) + "</IndoorFeatures>\n";
}

}  // namespace enfilade::topo_graph
