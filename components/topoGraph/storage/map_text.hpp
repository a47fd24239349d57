// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "components/topoGraph/core/topo_state.hpp"

/// The parts of a map file and of its journal as YAML. Each ends with a line end.
namespace enfilade::topo_graph::map_text {

/// Entries of a list that is indented by two blanks.
std::string room(const Room& room);
std::string door(const Door& door);
std::string link(const RoomLink& link);
std::string place(const Place& place);

/// The key `session` and all below it.
std::string session(const Session& session);

/// A key with its list; `write` gives an entry.
template <class Items, class Write>
std::string section(const char* key, const Items& items, Write&& write) {
  std::string out = std::string(key) + (items.empty() ? ": []\n" : ":\n");
  for (const auto& item : items) out += write(item);
  return out;
}

}  // namespace enfilade::topo_graph::map_text
