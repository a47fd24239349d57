// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "components/topoGraph/core/topo_state.hpp"

namespace enfilade::topo_graph {

/// A map file that cannot be used: "file:line: what is wrong; what to do".
class MapFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a file holds: always the map, and the session where it was written by a running topoGraph.
struct MapFile {
  TopologicalMap map;
  std::optional<Session> session;

  bool operator==(const MapFile&) const = default;
};

/// YAML for people, units in the key names, every number with all its digits: parse_map_file(to_yaml(x)) ==
/// x.
std::string to_yaml(const MapFile& file);

/// Strict: a file that is cut off, of another format or version, with unknown, missing, repeated or
/// impossible values is refused by MapFileError. `name` is what the errors call the file.
MapFile parse_map_file(const std::string& text, const std::string& name);

MapFile load_map_file(const std::filesystem::path& path);
/// Atomic and durable; throws std::system_error.
void save_map_file(const std::filesystem::path& path, const MapFile& file);

/// The map alone, for tools.
TopologicalMap load_map(const std::filesystem::path& path);
void save_map(const std::filesystem::path& path, const TopologicalMap& map);

/// Map and session, for topoGraph. A file without a session is refused: nothing tells where the robot is.
TopoState load_state(const std::filesystem::path& path);
void save_state(const std::filesystem::path& path, const TopoState& state);

}  // namespace enfilade::topo_graph
