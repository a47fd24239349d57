// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_file.hpp"

#include <exception>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>

#include "components/topoGraph/storage/atomic_file.hpp"

namespace enfilade::topo_graph {
namespace {

MapFile read_map_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw MapFileError(path.string() + ": cannot be opened; check the name and that it may be read");
  std::ostringstream text;
  text << in.rdbuf();
  if (in.bad()) throw MapFileError(path.string() + ": cannot be read; check the disk");
  return parse_map_file(text.str(), path.string());
}

/// " (…)" where the file that was there before the last change can be read; else nothing.
std::string offer_last_good(const std::filesystem::path& path) {
  const std::filesystem::path last = last_good(path);
  try {
    const MapFile file = read_map_file(last);
    return " (the last good copy, with " + std::to_string(file.map.rooms.size()) + " rooms, is " +
           last.string() + ": rename it to go on from there)";
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace

MapFile load_map_file(const std::filesystem::path& path) {
  try {
    return read_map_file(path);
  } catch (const MapFileError& error) {
    throw MapFileError(error.what() + offer_last_good(path));
  }
}

void save_map_file(const std::filesystem::path& path, const MapFile& file) {
  write_atomically(path, to_yaml(file));
}

TopologicalMap load_map(const std::filesystem::path& path) { return load_map_file(path).map; }

void save_map(const std::filesystem::path& path, const TopologicalMap& map) {
  save_map_file(path, {map, std::nullopt});
}

TopoState load_state(const std::filesystem::path& path) {
  MapFile file = load_map_file(path);
  if (!file.session) {
    throw MapFileError(
        path.string() +
        ":1: holds a map but no session, so nothing tells where the robot is; start with resume: false");
  }
  return {std::move(file.map), std::move(*file.session)};
}

void save_state(const std::filesystem::path& path, const TopoState& state) {
  save_map_file(path, {state.map, state.session});
}

}  // namespace enfilade::topo_graph
