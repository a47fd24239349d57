// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/atomic_file.hpp"

#include <string>

namespace enfilade::topo_graph {
namespace {

namespace fs = std::filesystem;

fs::path with_ending(const fs::path& path, const char* ending) { return path.string() + ending; }

void create_folders(const fs::path& folder, Disk& disk) {
  if (fs::exists(folder)) return;
  create_folders(folder_of(folder), disk);
  fs::create_directory(folder);
  disk.sync_folder(folder_of(folder));
}

/// By a second name, so that there is never a moment without the file itself.
void keep_old(const fs::path& path, const fs::path& old_one, Disk& disk) {
  const fs::path second = with_ending(old_one, ".tmp");
  disk.remove(second);
  if (disk.link(path, second)) disk.rename(second, old_one);
}

}  // namespace

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : "."; }

void write_atomically(const fs::path& path, std::string_view text, const fs::path& old_one, Disk& disk) {
  create_folders(folder_of(path), disk);
  const fs::path temporary = with_ending(path, ".tmp");
  disk.remove(temporary);  // not written over: after a crash it may be a second name of the file itself
  try {
    disk.create(temporary, text);
    disk.sync(temporary);
    keep_old(path, old_one, disk);
    disk.rename(temporary, path);
  } catch (...) {
    disk.remove(temporary);
    throw;
  }
  disk.sync_folder(folder_of(path));
}

}  // namespace enfilade::topo_graph
