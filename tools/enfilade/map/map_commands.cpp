// SPDX-License-Identifier: Apache-2.0
#include "tools/enfilade/map/map_commands.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "components/topoGraph/merge/map_merge.hpp"
#include "components/topoGraph/routes/map_check.hpp"
#include "components/topoGraph/storage/map_file.hpp"
#include "components/topoGraph/storage/map_restore.hpp"
#include "interfaces/model/counted.hpp"

namespace enfilade::map_tool {
namespace {

std::optional<double> parse_metres(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_number(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::optional<Point2> parse_point(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return std::nullopt;
  const auto x = parse_metres(text.substr(0, comma)), y = parse_metres(text.substr(comma + 1));
  if (!x || !y) return std::nullopt;
  return Point2(*x, *y);
}

RoutePlace route_place(const TopologicalMap& map, const std::string& file, const std::string& name) {
  const RoutePlace place = parse_place(map, file, name);
  if (place.room != 0) return place;
  if (const auto inside = topo_graph::place_at(map, place.point)) return *inside;
  throw std::runtime_error(
      fmt::format("{}: the point {} lies in no room; give one inside a room", file, name));
}

std::string contents(const TopologicalMap& map) {
  return counted(map.rooms.size(), "room") + ", " + counted(map.doors.size(), "door");
}

std::string leg_line(const TopologicalMap& map, const RouteLeg& leg) {
  const Room* room = map.find_room(leg.room);
  const std::string way = fmt::format("{:>8.3f} m  room {} ({})", (leg.leave - leg.enter).norm(), leg.room,
                                      room ? room->name : "new");
  if (!leg.door) return way + fmt::format(" to {:.3f},{:.3f}\n", leg.leave.x(), leg.leave.y());
  return way + fmt::format(" to door {} at {:.3f},{:.3f}\n", *leg.door, leg.leave.x(), leg.leave.y());
}

std::string no_such_door(const std::string& file, DoorId door) {
  return fmt::format("{}: there is no door {}; 'enfilade map show' lists them", file, door);
}

/// Whether each first byte is followed by as many others as it tells.
bool is_utf8(const std::string& text) {
  int expected = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool follows = (byte & 0xC0) == 0x80;
    if (follows != (expected > 0)) return false;
    if (follows)
      --expected;
    else if (byte >= 0xF8)
      return false;
    else
      expected = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : byte >= 0xC0 ? 1 : 0;
  }
  return expected == 0;
}

void check_name(const TopologicalMap& map, const Room& room, const std::string& name) {
  const bool printable = std::none_of(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  if (name.empty() || !printable || name.size() > 200 || !is_utf8(name))
    throw std::runtime_error(
        "a room's name has 1 to 200 characters of UTF-8, none of them a control character");
  if (is_number(name) || parse_point(name))
    throw std::runtime_error("\"" + name +
                             "\" could be taken for a room's number or a point; choose another name");
  for (const Room& other : map.rooms)
    if (other.id != room.id && other.name == name)
      throw std::runtime_error(
          fmt::format("room {} is called \"{}\" already; choose another name", other.id, name));
}

}  // namespace

const Room& find_room(const TopologicalMap& map, const std::string& file, const std::string& name) {
  const Room* found = nullptr;
  for (const Room& room : map.rooms) {
    if (room.name != name) continue;
    if (found)
      throw std::runtime_error(
          fmt::format("{}: rooms {} and {} are both called \"{}\"; give the number instead", file, found->id,
                      room.id, name));
    found = &room;
  }
  if (!found && is_number(name) && name.size() < 10)
    found = map.find_room(static_cast<RoomId>(std::stoul(name)));
  if (!found)
    throw std::runtime_error(
        fmt::format("{}: there is no room \"{}\"; 'enfilade map show' lists them", file, name));
  return *found;
}

RoutePlace parse_place(const TopologicalMap& map, const std::string& source, const std::string& name) {
  if (const auto point = parse_point(name)) return {.room = 0, .point = *point};
  return topo_graph::middle_of(find_room(map, source, name));
}

std::string describe(const TopologicalMap& map, const Route& route) {
  std::string text;
  for (const RouteLeg& leg : route.legs) text += leg_line(map, leg);
  return text + fmt::format("{:>8.3f} m  in all, through {}\n", route.length_m,
                            counted(route.legs.size() - 1, "door"));
}

std::optional<std::string> route(const RouteOptions& options) {
  const TopologicalMap map = topo_graph::load_map(options.file);
  for (const DoorId door : options.closed)
    if (!map.find_door(door)) throw std::runtime_error(no_such_door(options.file, door));
  const auto found = topo_graph::find_route(map, route_place(map, options.file, options.from),
                                            route_place(map, options.file, options.to),
                                            {options.closed.begin(), options.closed.end()});
  if (!found) return std::nullopt;
  return describe(map, *found);
}

std::vector<std::string> check(const std::string& file) {
  return topo_graph::check_map(topo_graph::load_map(file));
}

std::string merge(const std::string& first, const std::string& second, const std::string& out) {
  const TopologicalMap a = topo_graph::load_map(first), b = topo_graph::load_map(second);
  const auto same = [](const std::string& x, const std::string& y) {
    return std::filesystem::exists(y) && std::filesystem::equivalent(x, y);
  };
  if (same(first, out) || same(second, out))
    throw std::runtime_error("writing " + out +
                             " would destroy a map that is merged; give --out another name");
  try {
    const topo_graph::MergedMaps merged = topo_graph::merge_maps(a, b);
    topo_graph::save_map(out, merged.map);
    std::string text;
    for (const auto& [in_a, in_b] : merged.common)
      text += fmt::format("room {} of {} is room {} of {}\n", in_b, second, in_a, first);
    return text + fmt::format("wrote {}: {}\n", out, contents(merged.map));
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(first + " and " + second + ": " + error.what());
  }
}

std::string restore(const std::string& file) {
  const TopologicalMap map = topo_graph::restore_last_good(file).map;
  return fmt::format("{} is the last good map again: {}; the damaged one is {}.damaged\n", file,
                     contents(map), file);
}

std::string rename(const std::string& file, const std::string& room, const std::string& name) {
  topo_graph::MapFile content = topo_graph::load_map_file(file);
  const Room& found = find_room(content.map, file, room);
  check_name(content.map, found, name);
  const auto it = std::find_if(content.map.rooms.begin(), content.map.rooms.end(),
                               [&found](const Room& r) { return r.id == found.id; });
  const std::string before = std::exchange(it->name, name);
  ++content.map.version;
  topo_graph::save_map_file(file, content);
  return before;
}

void mark(const MarkOptions& options) {
  topo_graph::MapFile content = topo_graph::load_map_file(options.file);
  const auto door = std::ranges::find(content.map.doors, options.door, &Door::id);
  if (door == content.map.doors.end()) throw std::runtime_error(no_such_door(options.file, options.door));
  if (std::exchange(door->closed, options.closed) == options.closed) return;
  ++content.map.version;
  topo_graph::save_map_file(options.file, content);
}

}  // namespace enfilade::map_tool
