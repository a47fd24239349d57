// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_file.hpp"

#include "components/topoGraph/storage/journal.hpp"
#include "components/topoGraph/storage/map_consistency.hpp"
#include "components/topoGraph/storage/map_folder.hpp"
#include "components/topoGraph/storage/map_restore.hpp"

namespace enfilade::topo_graph {
namespace {

[[noreturn]] void refuse_journal(const Journal& journal, const std::string& name) {
  throw MapFileError(journal.name + ":4: continues record " + std::to_string(journal.base.record) +
                     " of another " + name + " than the one beside it, which was changed since or is a copy");
}

}  // namespace

OpenedMap open_map(const std::string& text, const std::optional<std::string>& journal_text,
                   const std::string& name) {
  OpenedMap opened{.file = parse_map_file(text, name)};
  if (!journal_text) return opened;
  MapFile& file = opened.file;
  const Journal journal = parse_journal(*journal_text, journal_of(name).string());
  if (journal.base != JournalBase{file.records, crc32_of(text)}) {
    if (journal.last_record() <= file.records && !journal.damage) return opened;
    refuse_journal(journal, name);
  }
  opened.torn = journal.torn;
  opened.replayed = journal.records.size();
  if (const auto damage = replay(journal, file)) throw MapFileError(*damage);
  if (const auto problem = find_contradiction(file))
    throw MapFileError(journal.name + ":1: its records do not fit the map: " + *problem);
  return opened;
}

OpenedMap open_map(const std::filesystem::path& path) {
  try {
    // In this order: a topoGraph that folds the journal into the file meanwhile does the file first.
    const std::optional<std::string> journal = read_if_there(journal_of(path));
    const std::optional<std::string> text = read_if_there(path);
    if (!text) throw MapFileError(path.string() + ": is not there; check the name");
    return open_map(*text, journal, path.string());
  } catch (const MapFileError& error) {
    throw MapFileError(error.what() + offer_last_good(path));
  }
}

MapFile load_map_file(const std::filesystem::path& path) { return open_map(path).file; }

TopologicalMap load_map(const std::filesystem::path& path) { return load_map_file(path).map; }

void save_map(const std::filesystem::path& path, const TopologicalMap& map) {
  save_map_file(path, {map, std::nullopt});
}

void save_map_file(const std::filesystem::path& path, const MapFile& file) {
  write_map_file(path, to_yaml(file));
  end_journal(path);
}

}  // namespace enfilade::topo_graph
