// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/topo_state.hpp"

#include <algorithm>
#include <utility>

namespace enfilade::topo_graph {

TopoState first_state(StampNs now_ns) {
  TopoState state;
  state.session.zone.zone_id = 1;
  state.session.zone.valid_from_ns = now_ns;
  state.map.stamp_ns = now_ns;
  state.map.places = {{.id = 1, .kind = PlaceKind::kBuilding, .name = "building"},
                      {.id = 2, .parent = 1, .kind = PlaceKind::kFloor, .name = "ground floor"}};
  return state;
}

TopoState lost_state(TopologicalMap map, const Session& before, StampNs now_ns) {
  TopoState state{.map = std::move(map)};
  state.session.zone = {.zone_id = before.zone.zone_id + 1, .located = false, .valid_from_ns = now_ns};
  state.session.last_room = before.last_room;
  state.session.last_door = before.last_door;
  state.session.closures = before.closures;
  return state;
}

const Answer* find_answer(const Session& session, RequestKind kind, const CallId& call) {
  const auto it = std::find_if(session.answers.begin(), session.answers.end(),
                               [&](const Answer& a) { return a.kind == kind && a.call == call; });
  return it == session.answers.end() ? nullptr : &*it;
}

void remember(Session& session, Answer answer, std::size_t capacity) {
  session.answers.push_back(std::move(answer));
  if (session.answers.size() <= capacity) return;
  const auto surplus = static_cast<std::ptrdiff_t>(session.answers.size() - capacity);
  session.answers.erase(session.answers.begin(), session.answers.begin() + surplus);
}

}  // namespace enfilade::topo_graph
