// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_folder.hpp"

#include <fstream>
#include <sstream>
#include <system_error>

#include "components/topoGraph/storage/atomic_file.hpp"
#include "components/topoGraph/storage/map_file.hpp"

namespace enfilade::topo_graph {

namespace fs = std::filesystem;

fs::path journal_of(const fs::path& path) { return path.string() + ".journal"; }
fs::path last_good(const fs::path& path) { return path.string() + ".last"; }

std::optional<std::string> read_if_there(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  if (!in && !fs::exists(path, error)) return std::nullopt;
  if (fs::is_directory(path, error))
    throw MapFileError(path.string() + ": is a folder; name the map file in it");
  if (!in) throw MapFileError(path.string() + ": cannot be opened; check that it may be read");
  if (const auto bytes = fs::file_size(path, error); !error && bytes > kMostMapBytes)
    throw MapFileError(path.string() + ": is larger than any map; check the name");
  std::ostringstream text;
  text << in.rdbuf();
  if (in.bad()) throw MapFileError(path.string() + ": cannot be read; check the disk");
  return text.str();
}

void write_map_file(const fs::path& path, std::string_view text, Disk& disk) {
  write_atomically(path, text, last_good(path), disk);
}

void begin_journal(const fs::path& path, std::string_view header, Disk& disk) {
  write_atomically(journal_of(path), header, journal_of(last_good(path)), disk);
}

void end_journal(const fs::path& path, Disk& disk) {
  if (!disk.exists(journal_of(path))) return;
  disk.rename(journal_of(path), journal_of(last_good(path)));
  disk.sync_folder(folder_of(path));
}

void move_map(const fs::path& from, const fs::path& to) {
  fs::remove(journal_of(to));
  if (fs::exists(journal_of(from))) fs::rename(journal_of(from), journal_of(to));
  fs::rename(from, to);
}

}  // namespace enfilade::topo_graph
