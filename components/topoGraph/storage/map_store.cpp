// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_store.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "components/topoGraph/storage/change_text.hpp"
#include "components/topoGraph/storage/journal.hpp"
#include "components/topoGraph/storage/map_folder.hpp"

namespace enfilade::topo_graph {
namespace {

KeptState kept_of(OpenedMap opened) {
  return {{std::move(opened.file.map), std::move(*opened.file.session)}, opened.file.records, opened.torn};
}

}  // namespace

KeptState load_kept(const std::filesystem::path& path) {
  OpenedMap opened = open_map(path);
  if (!opened.file.session) {
    throw MapFileError(path.string() +
                       ":1: holds a map but no session, so nothing tells where the robot is; start with "
                       "locate: true, or with resume: false");
  }
  return kept_of(std::move(opened));
}

KeptState load_to_locate(const std::filesystem::path& path) {
  OpenedMap opened = open_map(path);
  if (!opened.file.session) {
    Session& session = opened.file.session.emplace();
    for (const Room& room : opened.file.map.rooms) session.last_room = std::max(session.last_room, room.id);
    for (const Door& door : opened.file.map.doors) session.last_door = std::max(session.last_door, door.id);
  }
  return kept_of(std::move(opened));
}

TopoState load_state(const std::filesystem::path& path) { return load_kept(path).state; }

void save_state(const std::filesystem::path& path, const TopoState& state) {
  save_map_file(path, {state.map, state.session});
}

MapStore::MapStore(MapStoreConfig config, std::uint64_t records, Disk& disk)
    : config_(std::move(config)), disk_(&disk), records_(records) {}

void MapStore::begin(const TopoState& state) { fold(state, records_); }

void MapStore::keep(const TopoState& before, const TopoState& after) {
  const std::uint64_t number = records_ + 1;
  const std::string record = journal_record(number, to_yaml(change_between(before, after)));
  const std::size_t most_bytes = std::max(config_.journal_bytes, map_bytes_);
  if (!journal_sound_ || journal_bytes_ + record.size() > most_bytes) return fold(after, number);
  try {
    disk_->append(journal_of(config_.file), record);
    journal_bytes_ += record.size();
    records_ = number;
  } catch (const std::system_error&) {
    fold(after, number);
  }
}

void MapStore::end(const TopoState& state) {
  if (journal_sound_ && journal_bytes_ == 0) return disk_->remove(journal_of(config_.file));
  write_map(state, records_);
  end_journal(config_.file, *disk_);
}

/// A journal that cannot be begun does no harm: the next change is folded too.
void MapStore::fold(const TopoState& state, std::uint64_t records) {
  journal_sound_ = false;
  const std::uint32_t crc32 = write_map(state, records);
  try {
    begin_journal(config_.file, journal_header({records, crc32}), *disk_);
    journal_bytes_ = 0;
    journal_sound_ = true;
  } catch (const std::system_error&) {
  }
}

std::uint32_t MapStore::write_map(const TopoState& state, std::uint64_t records) {
  const std::string text = to_yaml({state.map, state.session, records});
  write_map_file(config_.file, text, *disk_);
  records_ = records;
  map_bytes_ = text.size();
  return crc32_of(text);
}

}  // namespace enfilade::topo_graph
