// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <utility>

#include "components/topoGraph/storage/map_file.hpp"
#include "components/topoGraph/storage/map_names.hpp"
#include "components/topoGraph/storage/map_values.hpp"
#include "components/topoGraph/storage/yaml_reader.hpp"

namespace enfilade::topo_graph {
namespace {

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

MapFile read_file(const std::string& text, const YamlSource& source) {
  YamlMap map(YamlValue(load_yaml(text, source), source, "the file"));
  const YamlValue format = map.take("format");
  if (format.text() != names::kFormat) format.fail("is not " + std::string(names::kFormat));
  const YamlValue version = map.take("version");
  const std::uint64_t number = version.count(std::numeric_limits<std::uint64_t>::max());
  if (number < 1 || number > names::kVersion)
    version.fail("this program reads versions 1 to " + std::to_string(names::kVersion));
  MapFile file;
  file.map.version = map.take("changes").count(std::numeric_limits<std::uint64_t>::max());
  file.map.stamp_ns = map.take("stamp_ns").signed_count();
  if (const auto records = map.take_if_present("records"))
    file.records = records->count(std::numeric_limits<std::uint64_t>::max() / 2);
  for (const YamlValue& room : map.take("rooms").list()) append(file.map.rooms, read_room(room), room);
  for (const YamlValue& door : map.take("doors").list())
    append(file.map.doors, read_door(door, &file.map), door);
  if (const auto links = map.take_if_present("links"))
    for (const YamlValue& link : links->list()) file.map.links.push_back(read_link(link, &file.map));
  if (const auto places = map.take_if_present("places"))
    for (const YamlValue& place : places->list()) append(file.map.places, read_place(place), place);
  if (const auto session = map.take_if_present("session")) file.session = read_session(*session, &file.map);
  map.take("end").must_be_on_last_line(text);
  map.finish();
  return file;
}

}  // namespace

MapFile parse_map_file(const std::string& text, const std::string& name) {
  check_frame(text, name);
  return read_file(text, YamlSource{name});
}

}  // namespace enfilade::topo_graph
