// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/change_text.hpp"

#include <limits>
#include <utility>

#include "components/topoGraph/storage/map_text.hpp"
#include "components/topoGraph/storage/map_values.hpp"

namespace enfilade::topo_graph {
namespace {

/// Keys are written only where something has changed.
template <class Item>
std::string items_text(const char* key, const ItemChange<Item>& change, std::string (*write)(const Item&)) {
  std::string out = change.put.empty() ? "" : map_text::section(key, change.put, write);
  if (change.removed.empty()) return out;
  out += std::string("removed_") + key + ": [";
  for (const std::uint32_t id : change.removed) out += (out.ends_with('[') ? "" : ", ") + std::to_string(id);
  return out + "]\n";
}

std::string kept_text(const MapChange& change) {
  return "kept: {links: " + std::to_string(change.links.kept) +
         ", closures: " + std::to_string(change.closures.kept) +
         ", answers: " + std::to_string(change.answers.kept) + "}  # of the lists before\n";
}

template <class Item, class Read>
ItemChange<Item> read_items(YamlMap& map, const std::string& key, Read&& read) {
  ItemChange<Item> change;
  std::uint32_t last = 0;
  const auto check = [&last](std::uint32_t id, const YamlValue& value) {
    if (id <= std::exchange(last, id)) value.fail("ids must grow from one entry to the next");
  };
  if (const auto put = map.take_if_present(key.c_str()))
    for (const YamlValue& value : put->list()) {
      change.put.push_back(read(value));
      check(change.put.back().id, value);
    }
  last = 0;
  if (const auto removed = map.take_if_present(("removed_" + key).c_str()))
    for (const YamlValue& value : removed->list()) {
      change.removed.push_back(value.id());
      check(value.id(), value);
    }
  return change;
}

void read_kept(const YamlValue& value, MapChange& change) {
  YamlMap map(value);
  const auto count = [&map](const char* key) {
    return static_cast<std::size_t>(map.take(key).count(std::numeric_limits<std::uint32_t>::max()));
  };
  change.links.kept = count("links");
  change.closures.kept = count("closures");
  change.answers.kept = count("answers");
  map.finish();
}

}  // namespace

std::string to_yaml(const MapChange& change) {
  std::string out =
      "changes: " + std::to_string(change.version) + "\nstamp_ns: " + std::to_string(change.stamp_ns) + "\n";
  out += items_text("rooms", change.rooms, map_text::room) +
         items_text("doors", change.doors, map_text::door) +
         items_text("places", change.places, map_text::place) + kept_text(change);
  if (!change.links.added.empty()) out += map_text::section("links", change.links.added, map_text::link);
  Session session = change.session;
  session.closures = change.closures.added;
  session.answers = change.answers.added;
  return out + map_text::session(session);
}

MapChange parse_change(const std::string& text, const YamlSource& source) {
  const YAML::Node root = load_yaml(text, source);
  YamlMap map(YamlValue(root, source, "the record"));
  MapChange change;
  change.version = map.take("changes").count(std::numeric_limits<std::uint64_t>::max());
  change.stamp_ns = map.take("stamp_ns").signed_count();
  change.rooms = read_items<Room>(map, "rooms", read_room);
  change.doors = read_items<Door>(map, "doors", [](const auto& value) { return read_door(value, nullptr); });
  change.places = read_items<Place>(map, "places", read_place);
  read_kept(map.take("kept"), change);
  if (const auto links = map.take_if_present("links"))
    for (const YamlValue& link : links->list()) change.links.added.push_back(read_link(link, nullptr));
  change.session = read_session(map.take("session"), nullptr);
  change.closures.added = std::exchange(change.session.closures, {});
  change.answers.added = std::exchange(change.session.answers, {});
  map.finish();
  return change;
}

}  // namespace enfilade::topo_graph
