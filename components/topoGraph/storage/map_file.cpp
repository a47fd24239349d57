// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_file.hpp"

#include <fstream>
#include <sstream>
#include <utility>

#include "components/topoGraph/storage/atomic_file.hpp"

namespace enfilade::topo_graph {

MapFile load_map_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw MapFileError(path.string() + ": cannot be opened; check the name and that it may be read");
  std::ostringstream text;
  text << in.rdbuf();
  if (in.bad()) throw MapFileError(path.string() + ": cannot be read; check the disk");
  return parse_map_file(text.str(), path.string());
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
