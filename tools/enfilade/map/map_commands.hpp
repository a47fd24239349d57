// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "components/topoGraph/routes/route.hpp"
#include "interfaces/model/topological_map.hpp"

/// What `enfilade map` does to a map file. Wrong input is told by std::exception: one sentence that names it.
namespace enfilade::map_tool {

/// Rooms, doors and sums, for people.
std::string show(const std::string& file);

struct ExportOptions {
  std::string file, format, out;  ///< format "" = by the ending of `out`
  double resolution_m = 0.05;
  std::vector<RoomId> rooms;  ///< empty = all
};
/// Returns the files written.
std::vector<std::string> export_map(const ExportOptions& options);

/// A room by its id or its name.
const Room& find_room(const TopologicalMap& map, const std::string& file, const std::string& name);

/// "X,Y" as a point of the map (room 0), anything else as a room of it. `source` is where the map comes from,
/// for people.
RoutePlace parse_place(const TopologicalMap& map, const std::string& source, const std::string& name);

/// The way, one line a room.
std::string describe(const TopologicalMap& map, const Route& route);

struct RouteOptions {
  std::string file, from, to;  ///< a room, or "X,Y" in the map frame
  std::vector<DoorId> closed;
};
/// The way as text; nothing where there is none.
std::optional<std::string> route(const RouteOptions& options);

/// What is wrong with the map, a sentence each.
std::vector<std::string> check(const std::string& file);

/// Writes a map of the rooms of both; returns what was done, for people.
std::string merge(const std::string& first, const std::string& second, const std::string& out);

/// Puts the last good map in place of a damaged one; returns what was done, for people.
std::string restore(const std::string& file);

struct MarkOptions {
  std::string file;
  DoorId door = 0;
  bool closed = false;
};
void mark(const MarkOptions& options);

/// Returns the old name.
std::string rename(const std::string& file, const std::string& room, const std::string& name);

}  // namespace enfilade::map_tool
