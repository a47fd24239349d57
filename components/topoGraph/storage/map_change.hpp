// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "components/topoGraph/core/topo_state.hpp"

namespace enfilade::topo_graph {

/// What happened to things that have ids.
template <class Item>
struct ItemChange {
  std::vector<Item> put;  ///< new or replaced, by id
  std::vector<std::uint32_t> removed;

  bool operator==(const ItemChange&) const = default;
};

/// What happened to a list that grows at its end.
template <class Item>
struct ListChange {
  std::size_t kept = 0;  ///< of the old ones
  std::vector<Item> added;

  bool operator==(const ListChange&) const = default;
};

/// The difference between two states: what a journal keeps. Its size is that of what has changed, but that
/// the session is in it as a whole, without its lists.
struct MapChange {
  std::uint64_t version = 0;
  StampNs stamp_ns = 0;
  ItemChange<Room> rooms;
  ItemChange<Door> doors;
  ItemChange<Place> places;
  ListChange<RoomLink> links;        ///< the first ones are kept
  Session session;                   ///< closures and answers are empty
  ListChange<LoopClosure> closures;  ///< the first ones are kept
  ListChange<Answer> answers;        ///< the last ones are kept

  bool operator==(const MapChange&) const = default;
};

MapChange change_between(const TopoState& before, const TopoState& after);

/// After apply(change_between(a, b), a.map, a.session), a == b. Throws std::invalid_argument where the change
/// does not fit, and leaves both as they were: something is removed that is not there, or more is kept than
/// there is.
void apply(const MapChange& change, TopologicalMap& map, Session& session);

}  // namespace enfilade::topo_graph
