// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "components/topoGraph/storage/map_file.hpp"

/// The text of a journal: a header, then one YAML document for each change that was accepted since the map
/// file was written.
///
///   format: enfilade-map-journal
///   version: 1
///   continues: {record: 57, crc32: 1a2b3c4d}
///   ---  # record 58, 812 bytes
///   changes: 18
///   …
///   # record 58 is complete: crc32 9f8e7d6c
namespace enfilade::topo_graph {

/// What a journal goes on from.
struct JournalBase {
  std::uint64_t record = 0;  ///< the last one that the map file holds already
  std::uint32_t crc32 = 0;   ///< of the map file's text

  bool operator==(const JournalBase&) const = default;
};

struct JournalRecord {
  std::uint64_t number = 0;
  int line = 0;      ///< of the file, before the text
  std::string text;  ///< a MapChange in YAML, as it was written
};

struct Journal {
  std::string name;  ///< of its file
  JournalBase base;
  std::vector<JournalRecord> records;  ///< numbered one by one after the base
  /// "file:line: …": a crash has left a part of a record, which was thus never announced.
  std::optional<std::string> torn;
  /// "file:line: …": what follows the records was changed after it was written.
  std::optional<std::string> damage;

  std::uint64_t last_record() const { return base.record + records.size(); }
};

std::uint32_t crc32_of(std::string_view text);

std::string journal_header(const JournalBase& base);
/// `change`: a MapChange in YAML.
std::string journal_record(std::uint64_t number, std::string_view change);

/// Throws MapFileError where the header cannot be used.
Journal parse_journal(const std::string& text, const std::string& name);

/// Applies the records, one after the other, as far as they can be used. The file must be what they go on
/// from. Returns what is wrong with the next one.
std::optional<std::string> replay(const Journal& journal, MapFile& file);

}  // namespace enfilade::topo_graph
