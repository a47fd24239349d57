// SPDX-License-Identifier: Apache-2.0
#include <sstream>

#include "components/topoGraph/storage/map_consistency.hpp"
#include "tests/fuzz/fuzz.hpp"
#include "tests/fuzz/map_texts.hpp"

namespace enfilade::topo_graph {
namespace {

template <class Read>
bool is_refused(Read&& read) {
  try {
    read();
    return false;
  } catch (const MapFileError&) {
    return true;
  }
}

void check_map(const MapFile& file) {
  MapFile again;
  fuzz::must(!is_refused([&] { again = parse_map_file(to_yaml(file), "again"); }),
             "a map that was accepted is accepted when it was written");
  fuzz::must(again == file, "a map that was accepted is the same when it was written and read");
  fuzz::must(!find_contradiction(file), "a map that was accepted has no contradictions");
}

void check_change(const std::string& text) {
  MapChange change, again;
  if (is_refused([&] { change = parse_change(text, {"change"}); })) return;
  fuzz::must(!is_refused([&] { again = parse_change(to_yaml(change), {"again"}); }),
             "a change that was accepted is accepted when it was written");
  fuzz::must(again == change, "a change that was accepted is the same when it was written and read");
}

}  // namespace
}  // namespace enfilade::topo_graph

/// A map file, and the texts of changes in its journal.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace enfilade;
  std::istringstream parts(fuzz::text_of(data, size));
  fuzz::MapTexts texts;
  std::getline(parts, texts.map, fuzz::kSeparator);
  for (std::string change; std::getline(parts, change, fuzz::kSeparator);) texts.changes.push_back(change);
  for (const std::string& change : texts.changes) topo_graph::check_change(change);
  try {
    const topo_graph::MapFile file = topo_graph::parse_map_file(texts.map, "map.yaml");
    topo_graph::check_map(file);
    const std::string journal = fuzz::journal_with(texts.changes, texts.map, file.records);
    topo_graph::check_map(topo_graph::open_map(texts.map, journal, "map.yaml").file);
  } catch (const topo_graph::MapFileError&) {
  }
  return 0;
}
