// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_change.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace enfilade::topo_graph {
namespace {

using std::ptrdiff_t;

/// Both lists grow by id.
template <class Item>
ItemChange<Item> changed_items(const std::vector<Item>& before, const std::vector<Item>& after) {
  ItemChange<Item> change;
  auto old = before.begin();
  for (const Item& item : after) {
    for (; old != before.end() && old->id < item.id; ++old) change.removed.push_back(old->id);
    const bool known = old != before.end() && old->id == item.id;
    if (!known || *old != item) change.put.push_back(item);
    if (known) ++old;
  }
  for (; old != before.end(); ++old) change.removed.push_back(old->id);
  return change;
}

template <class Item>
ListChange<Item> first_kept(const std::vector<Item>& before, const std::vector<Item>& after) {
  const auto [end, next] = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  return {static_cast<std::size_t>(end - before.begin()), {next, after.end()}};
}

template <class Item>
ListChange<Item> last_kept(const std::vector<Item>& before, const std::vector<Item>& after) {
  std::size_t kept = std::min(before.size(), after.size());
  while (!std::equal(before.end() - static_cast<ptrdiff_t>(kept), before.end(), after.begin(),
                     after.begin() + static_cast<ptrdiff_t>(kept)))
    --kept;
  return {kept, {after.begin() + static_cast<ptrdiff_t>(kept), after.end()}};
}

/// Of the item with that id, or where it would be.
template <class Items>
auto place_of(Items& items, std::uint32_t id) {
  const auto less = [](const auto& item, std::uint32_t wanted) { return item.id < wanted; };
  return std::lower_bound(items.begin(), items.end(), id, less);
}

template <class Item>
void check_fit(const ItemChange<Item>& change, const std::vector<Item>& items) {
  for (const std::uint32_t id : change.removed) {
    const auto at = place_of(items, id);
    if (at == items.end() || at->id != id)
      throw std::invalid_argument(std::to_string(id) + " is removed, but is not there");
  }
}

template <class Item>
void check_fit(const ListChange<Item>& change, const std::vector<Item>& items) {
  if (change.kept > items.size())
    throw std::invalid_argument(std::to_string(change.kept) + " entries of a list are kept, but it has " +
                                std::to_string(items.size()));
}

void check_fit(const MapChange& change, const TopologicalMap& map, const Session& session) {
  check_fit(change.rooms, map.rooms);
  check_fit(change.doors, map.doors);
  check_fit(change.places, map.places);
  check_fit(change.links, map.links);
  check_fit(change.closures, session.closures);
  check_fit(change.answers, session.answers);
}

template <class Item>
void apply(const ItemChange<Item>& change, std::vector<Item>& items) {
  const auto is_removed = [&change](const Item& item) {
    return std::binary_search(change.removed.begin(), change.removed.end(), item.id);
  };
  if (!change.removed.empty()) std::erase_if(items, is_removed);
  for (const Item& item : change.put) {
    const auto at = place_of(items, item.id);
    if (at != items.end() && at->id == item.id)
      *at = item;
    else
      items.insert(at, item);
  }
}

template <class Item>
void add(const std::vector<Item>& added, std::vector<Item>& items) {
  items.insert(items.end(), added.begin(), added.end());
}

template <class Item>
void keep_first(const ListChange<Item>& change, std::vector<Item>& items) {
  items.erase(items.begin() + static_cast<ptrdiff_t>(change.kept), items.end());
  add(change.added, items);
}

template <class Item>
void keep_last(const ListChange<Item>& change, std::vector<Item>& items) {
  items.erase(items.begin(), items.end() - static_cast<ptrdiff_t>(change.kept));
  add(change.added, items);
}

Session without_lists(Session session) {
  session.closures.clear();
  session.answers.clear();
  return session;
}

}  // namespace

MapChange change_between(const TopoState& before, const TopoState& after) {
  return {.version = after.map.version,
          .stamp_ns = after.map.stamp_ns,
          .rooms = changed_items(before.map.rooms, after.map.rooms),
          .doors = changed_items(before.map.doors, after.map.doors),
          .places = changed_items(before.map.places, after.map.places),
          .links = first_kept(before.map.links, after.map.links),
          .session = without_lists(after.session),
          .closures = first_kept(before.session.closures, after.session.closures),
          .answers = last_kept(before.session.answers, after.session.answers)};
}

void apply(const MapChange& change, TopologicalMap& map, Session& session) {
  check_fit(change, map, session);
  map.version = change.version;
  map.stamp_ns = change.stamp_ns;
  apply(change.rooms, map.rooms);
  apply(change.doors, map.doors);
  apply(change.places, map.places);
  keep_first(change.links, map.links);
  Session after = change.session;
  after.closures = std::move(session.closures);
  after.answers = std::move(session.answers);
  keep_first(change.closures, after.closures);
  keep_last(change.answers, after.answers);
  session = std::move(after);
}

}  // namespace enfilade::topo_graph
