// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
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
  std::uint64_t records = 0;  ///< the last record of its journal that is in here

  bool operator==(const MapFile&) const = default;
};

/// A larger file is refused: a thousand times the rooms that any building has.
inline constexpr std::size_t kMostMapBytes = std::size_t{1} << 30;

/// YAML for people, units in the key names, every number with all its digits: parse_map_file(to_yaml(x)) ==
/// x.
std::string to_yaml(const MapFile& file);

/// Strict: a file that is cut off, of another format or version, with unknown, missing, repeated or
/// impossible values is refused by MapFileError. `name` is what the errors call the file.
MapFile parse_map_file(const std::string& text, const std::string& name);

/// A map file with the changes of its journal.
struct OpenedMap {
  MapFile file;
  std::size_t replayed = 0;         ///< changes that the journal had
  std::optional<std::string> torn;  ///< "file:line: …": what a crash left of a change that was not announced
};

/// By the text of the file and of its journal, where there is one. A journal whose records are all in the
/// file already is passed over. Throws MapFileError.
OpenedMap open_map(const std::string& text, const std::optional<std::string>& journal,
                   const std::string& name);

/// Throws MapFileError, which names the way back to the last good map where there is one.
OpenedMap open_map(const std::filesystem::path& path);

MapFile load_map_file(const std::filesystem::path& path);
/// Atomic and durable, and the end of the file's journal; throws std::system_error.
void save_map_file(const std::filesystem::path& path, const MapFile& file);

/// The map alone, for tools.
TopologicalMap load_map(const std::filesystem::path& path);
void save_map(const std::filesystem::path& path, const TopologicalMap& map);

}  // namespace enfilade::topo_graph
