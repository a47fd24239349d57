// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "components/topoGraph/storage/change_text.hpp"
#include "components/topoGraph/storage/journal.hpp"
#include "tests/unit/components/topoGraph/random_state.hpp"

namespace enfilade::fuzz {

/// Between the texts of one input; no YAML that we write has it.
inline constexpr char kSeparator = '\x1e';

/// A map file and the changes that follow it.
struct MapTexts {
  std::string map;
  std::vector<std::string> changes;
};

inline MapTexts make_map_texts(int changes_before, int changes, std::uint64_t seed) {
  topo_graph::test::RandomState random(seed);
  for (int i = 0; i < changes_before; ++i) random.change();
  MapTexts texts{.map = to_yaml(topo_graph::MapFile{random.state().map, random.state().session, 7})};
  for (int i = 0; i < changes; ++i) {
    const topo_graph::TopoState before = random.state();
    texts.changes.push_back(to_yaml(topo_graph::change_between(before, random.change())));
  }
  return texts;
}

/// What the target `journal` reads journals beside.
inline MapTexts map_beside_journal() { return make_map_texts(2, 4, 1); }

/// With the numbers and check sums that belong to it, so that nothing is refused for these.
inline std::string journal_with(const std::vector<std::string>& changes, const std::string& map,
                                std::uint64_t records) {
  std::string journal = topo_graph::journal_header({records, topo_graph::crc32_of(map)});
  for (const std::string& change : changes) journal += topo_graph::journal_record(++records, change);
  return journal;
}

}  // namespace enfilade::fuzz
