// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/storage/map_change.hpp"

#include <stdexcept>

#include <gtest/gtest.h>

#include "components/topoGraph/storage/change_text.hpp"
#include "tests/unit/components/topoGraph/random_state.hpp"

namespace enfilade::topo_graph {
namespace {

using test::RandomState;

TopoState applied(const MapChange& change, TopoState state) {
  apply(change, state.map, state.session);
  return state;
}

TEST(MapChange, TurnsTheStateBeforeIntoTheOneAfter) {
  RandomState random(1);
  for (int i = 0; i < 1000; ++i) {
    const TopoState before = random.state();
    const TopoState& after = random.change();
    ASSERT_EQ(applied(change_between(before, after), before), after) << i;
  }
  EXPECT_GT(random.state().map.rooms.size(), 20u);  // or little was put to the test
}

TEST(MapChange, LeadsFromAnyStateToAnyOther) {
  RandomState one(2), other(3);
  for (int i = 0; i < 200; ++i) {
    const TopoState& a = one.change();
    const TopoState& b = other.change();
    ASSERT_EQ(applied(change_between(a, b), a), b) << i;
    ASSERT_EQ(applied(change_between(b, a), b), a) << i;
  }
}

TEST(MapChange, IsReadBackFromItsText) {
  RandomState random(4);
  for (int i = 0; i < 300; ++i) {
    const TopoState before = random.state();
    const MapChange change = change_between(before, random.change());
    ASSERT_EQ(parse_change(to_yaml(change), {"x"}), change) << to_yaml(change);
  }
}

TEST(MapChange, IsAsLargeAsWhatHasChanged) {
  RandomState random(5);
  for (int i = 0; i < 300; ++i) random.change();
  const TopoState before = random.state();
  TopoState after = before;
  after.map.rooms[3].name = "kitchen";
  after.session.answers.erase(after.session.answers.begin());
  after.session.answers.push_back({.message = "new"});
  const MapChange change = change_between(before, after);
  EXPECT_EQ(change.rooms.put, std::vector<Room>{after.map.rooms[3]});
  EXPECT_TRUE(change.doors.put.empty() && change.places.put.empty() && change.links.added.empty());
  EXPECT_EQ(change.answers.added, std::vector<Answer>{after.session.answers.back()});
}

TEST(MapChange, ThatDoesNotFitLeavesTheStateAlone) {
  RandomState random(6);
  for (int i = 0; i < 50; ++i) random.change();
  const TopoState state = random.state();
  const auto refuses = [&state](auto&& spoil) {
    MapChange change = change_between({}, state);
    spoil(change);
    TopoState same = state;
    EXPECT_THROW(apply(change, same.map, same.session), std::invalid_argument);
    EXPECT_EQ(same, state);
  };
  refuses([](MapChange& change) { change.rooms.removed = {9999}; });
  refuses([](MapChange& change) { change.doors.removed = {0}; });
  refuses([&](MapChange& change) { change.links.kept = state.map.links.size() + 1; });
  refuses([](MapChange& change) { change.answers.kept = 9999; });
}

}  // namespace
}  // namespace enfilade::topo_graph
