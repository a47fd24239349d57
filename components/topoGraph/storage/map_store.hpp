// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "components/topoGraph/core/topo_state.hpp"
#include "components/topoGraph/storage/disk.hpp"

namespace enfilade::topo_graph {

/// What a restarted topoGraph goes on with.
struct KeptState {
  TopoState state;
  std::uint64_t records = 0;
  std::optional<std::string> torn;  ///< what a crash left of a change that was not announced
};

/// Throws MapFileError; also where the file has no session, since nothing tells then where the robot is.
KeptState load_kept(const std::filesystem::path& path);
/// The same for a robot that is to find its own place: a map that a tool made has no session and needs none.
KeptState load_to_locate(const std::filesystem::path& path);
TopoState load_state(const std::filesystem::path& path);
/// The whole state in one file.
void save_state(const std::filesystem::path& path, const TopoState& state);

struct MapStoreConfig {
  std::filesystem::path file;
  /// The journal is folded into the map file when it would be larger than this and than the map file.
  std::size_t journal_bytes = 65536;
};

/// Keeps a state that changes: the map file, and beside it a journal of what has changed since. Whatever
/// begin() or keep() were given is on the disk when they return. Both throw std::system_error where it cannot
/// be put there; it may be there all the same.
class MapStore {
 public:
  /// `records`: of the state in the file, from load_kept(); 0 for a new file.
  MapStore(MapStoreConfig config, std::uint64_t records, Disk& disk = real_disk());

  void begin(const TopoState& state);
  void keep(const TopoState& before, const TopoState& after);
  /// Leaves all in the map file alone.
  void end(const TopoState& state);

 private:
  void fold(const TopoState& state, std::uint64_t records);
  std::uint32_t write_map(const TopoState& state, std::uint64_t records);

  MapStoreConfig config_;
  Disk* disk_;
  std::uint64_t records_;
  bool journal_sound_ = false;  ///< it continues the map file, and ends with a whole record
  std::size_t map_bytes_ = 0, journal_bytes_ = 0;
};

}  // namespace enfilade::topo_graph
