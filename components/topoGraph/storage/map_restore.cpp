// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_restore.hpp"

#include <initializer_list>

#include "components/topoGraph/storage/atomic_file.hpp"
#include "components/topoGraph/storage/journal.hpp"
#include "components/topoGraph/storage/map_consistency.hpp"
#include "components/topoGraph/storage/map_folder.hpp"

namespace enfilade::topo_graph {
namespace {

namespace fs = std::filesystem;

/// With the changes of the journal, as far as they are good, if it continues this very map.
MapFile continued_by(const fs::path& journal_path, MapFile file, std::uint32_t crc32) {
  try {
    const auto text = read_if_there(journal_path);
    if (!text) return file;
    const Journal journal = parse_journal(*text, journal_path.string());
    MapFile longer = file;
    if (journal.base == JournalBase{file.records, crc32}) replay(journal, longer);
    return find_contradiction(longer) ? file : longer;
  } catch (const MapFileError&) {
    return file;
  }
}

/// A map file as the text says it; nothing where it is damaged.
std::optional<MapFile> good_map(const fs::path& path, std::initializer_list<fs::path> journals) {
  try {
    const auto text = read_if_there(path);
    if (!text) return std::nullopt;
    MapFile file = parse_map_file(*text, path.string());
    std::uint32_t crc32 = crc32_of(*text);
    for (const fs::path& journal : journals) {
      file = continued_by(journal, file, crc32);
      crc32 = crc32_of(to_yaml(file));  // of the file that was written when the next journal was begun
    }
    return file;
  } catch (const MapFileError&) {
    return std::nullopt;
  }
}

bool is_damaged(const fs::path& path) {
  try {
    const auto text = read_if_there(path);
    if (!text) return true;
    open_map(*text, read_if_there(journal_of(path)), path.string());
    return false;
  } catch (const MapFileError&) {
    return true;
  }
}

}  // namespace

std::optional<MapFile> find_last_good(const fs::path& path) {
  const auto present = good_map(path, {journal_of(path)});
  const auto last = good_map(last_good(path), {journal_of(last_good(path)), journal_of(path)});
  if (!present || !last) return present ? present : last;
  return last->records > present->records ? last : present;
}

std::string offer_last_good(const fs::path& path) {
  const auto file = find_last_good(path);
  if (!file) return {};
  return " (the last good map has " + std::to_string(file->map.rooms.size()) +
         " rooms: 'enfilade map restore " + path.string() + "' puts it back)";
}

MapFile restore_last_good(const fs::path& path) {
  if (!is_damaged(path)) throw MapFileError(path.string() + ": is not damaged, so it is left as it is");
  const auto file = find_last_good(path);
  if (!file) throw MapFileError(path.string() + ": there is no good map beside it; take an older copy");
  const fs::path damaged = path.string() + ".damaged";
  write_atomically(path, to_yaml(*file), damaged);
  // Last: without its damaged journal the map would seem whole before it is.
  if (fs::exists(journal_of(path))) fs::rename(journal_of(path), journal_of(damaged));
  return *file;
}

}  // namespace enfilade::topo_graph
