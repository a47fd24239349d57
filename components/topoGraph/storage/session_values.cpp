// SPDX-License-Identifier: Apache-2.0
#include <limits>

#include "components/topoGraph/storage/map_names.hpp"
#include "components/topoGraph/storage/map_values.hpp"

namespace enfilade::topo_graph {
namespace {

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

std::optional<std::uint32_t> read_room_id(YamlMap& map, const char* key, const TopologicalMap* graph) {
  const auto value = map.take_if_present(key);
  if (!value) return std::nullopt;
  return read_known_room(*value, graph);
}

CurrentZone read_zone(YamlMap& map, const TopologicalMap* graph) {
  CurrentZone zone;
  zone.zone_id = map.take("zone_id").id();
  zone.room = read_room_id(map, "room", graph);
  zone.from_room = read_room_id(map, "from_room", graph);
  if (const auto door = map.take_if_present("via_door")) {
    zone.via_door = door->id();
    if (graph && !graph->find_door(*zone.via_door))
      door->fail("there is no door " + std::to_string(*zone.via_door));
  }
  zone.T_map_zone = read_pose(map.take("T_map_zone"));
  if (const auto located = map.take_if_present("located")) zone.located = located->flag();
  zone.valid_from_ns = map.take("valid_from_ns").signed_count();
  return zone;
}

/// Ids in use are not given again.
template <class Item>
std::uint32_t read_last_id(const YamlValue& value, const std::vector<Item>* items) {
  const auto last = static_cast<std::uint32_t>(value.count(std::numeric_limits<std::uint32_t>::max()));
  if (items && !items->empty() && last < items->back().id) value.fail("is less than an id in use");
  return last;
}

LoopClosure read_closure(const YamlValue& value, const TopologicalMap* graph) {
  YamlMap map(value);
  LoopClosure closure;
  const YamlValue door = map.take("door");
  closure.door = door.id();
  if (graph && !graph->find_door(closure.door)) door.fail("there is no door " + std::to_string(closure.door));
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

}  // namespace

Session read_session(const YamlValue& value, const TopologicalMap* graph) {
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
  session.last_room = read_last_id(map.take("last_room"), graph ? &graph->rooms : nullptr);
  session.last_door = read_last_id(map.take("last_door"), graph ? &graph->doors : nullptr);
  for (const YamlValue& answer : map.take("answers").list()) session.answers.push_back(read_answer(answer));
  map.finish();
  return session;
}

}  // namespace enfilade::topo_graph
