// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/map_texts.hpp"

namespace enfilade::topo_graph {
namespace {

/// A map, and its states after each of the changes that its journal may hold.
struct KnownMap {
  fuzz::MapTexts texts = fuzz::map_beside_journal();
  std::vector<MapFile> states{parse_map_file(texts.map, "map.yaml")};

  KnownMap() {
    for (const std::string& change : texts.changes) {
      MapFile next = states.back();
      apply(parse_change(change, {"change"}), next.map, *next.session);
      ++next.records;
      states.push_back(next);
    }
  }

  /// A fuzzer that looks into comparisons can find a check sum, so it may write records of its own.
  bool wrote(const Journal& journal) const {
    return std::all_of(journal.records.begin(), journal.records.end(), [this](const JournalRecord& record) {
      return std::find(texts.changes.begin(), texts.changes.end(), record.text) != texts.changes.end();
    });
  }
};

void check_journal(const KnownMap& known, const std::string& text) {
  const MapFile file = open_map(known.texts.map, text, "map.yaml").file;
  fuzz::must(parse_map_file(to_yaml(file), "again") == file,
             "a map that was accepted is the same when it was written and read");
  if (!known.wrote(parse_journal(text, "map.yaml.journal"))) return;
  fuzz::must(std::find(known.states.begin(), known.states.end(), file) != known.states.end(),
             "what is accepted of a journal are its first records, as they were written");
}

}  // namespace
}  // namespace enfilade::topo_graph

/// The bytes of a journal beside a map that is good.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace enfilade;
  static const topo_graph::KnownMap known;
  try {
    topo_graph::check_journal(known, fuzz::text_of(data, size));
  } catch (const topo_graph::MapFileError&) {
  }
  return 0;
}
