// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/map_minimiser.hpp"

#include <algorithm>
#include <stdexcept>

#include "components/topoGraph/core/graph_edit.hpp"

namespace enfilade::topo_graph {
namespace {

/// The room that carries the robot.
std::optional<RoomId> anchor(const CurrentZone& zone) { return zone.room ? zone.room : zone.from_room; }

void move_zone(Session& session, const Pose2& before, const Pose2& after) {
  const Pose2 motion = after * before.inverse();
  session.zone.T_map_zone = motion * session.zone.T_map_zone;
  if (session.reference) session.reference = motion * *session.reference;
}

void take_over(const GraphSolution& solution, const MapProblem& problem, TopoState& state) {
  const auto room = anchor(state.session.zone);
  const auto before = room ? std::optional(get_room(state, *room).T_map_room) : std::nullopt;
  apply(solution, problem, state.map);
  if (before) move_zone(state.session, *before, get_room(state, *room).T_map_room);
}

}  // namespace

MapMinimiser::MapMinimiser(const MapMinimiserConfig& config, const UncertaintyConfig& uncertainty)
    : config_(config), uncertainty_(uncertainty), solver_(make_solver(config.solver)) {
  if (config.withdraw_weight < 0.0 || config.withdraw_weight >= 1.0)
    throw std::invalid_argument("MapMinimiser: withdraw_weight must be in [0, 1)");
}

Minimised MapMinimiser::minimise(TopoState& state, const std::vector<DoorId>& fresh) const {
  Minimised result;
  if (state.map.rooms.size() < 2) return result;
  result.moved = true;
  for (const DoorId door : fresh) {
    if (accept(state, door)) continue;
    withdraw(state, door);
    result.withdrawn.push_back(door);
  }
  for (;;) {
    const TopoState before = state;
    const std::vector<DoorId> doubtful = minimise_once(state);
    if (doubtful.empty()) return result;
    state = before;  // what a wrong door has bent is put back first
    withdraw(state, doubtful.front());
    result.withdrawn.push_back(doubtful.front());
  }
}

/// A long loop may close with an error of many sigmas of its door alone, which a robust loss would ignore: it
/// is closed by force first, and judged by what that costs everything else.
bool MapMinimiser::accept(TopoState& state, DoorId fresh) const {
  MapProblem closed = map_problem(state.map, uncertainty_), open = closed;
  const auto it = std::find(closed.doors.begin(), closed.doors.end(), fresh);
  if (it == closed.doors.end()) return true;
  const auto index = it - closed.doors.begin();
  closed.problem.doors[static_cast<std::size_t>(index)].loop = false;
  open.problem.doors.erase(open.problem.doors.begin() + index);
  const GraphSolution solution = solver_->solve(closed.problem);
  if (solution.final_cost - solver_->solve(open.problem).final_cost > config_.withdraw_nats) return false;
  take_over(solution, closed, state);
  return true;
}

/// The inferred doors that the solution disbelieves, the worst one first.
std::vector<DoorId> MapMinimiser::minimise_once(TopoState& state) const {
  const MapProblem problem = map_problem(state.map, uncertainty_);
  const GraphSolution solution = solver_->solve(problem.problem);
  std::vector<std::pair<double, DoorId>> doubtful;
  for (std::size_t i = 0; i < problem.doors.size(); ++i) {
    const double weight = solution.doors[i].weight;
    if (problem.problem.doors[i].loop && weight < config_.withdraw_weight)
      doubtful.emplace_back(weight, problem.doors[i]);
  }
  take_over(solution, problem, state);
  std::sort(doubtful.begin(), doubtful.end());
  std::vector<DoorId> doors;
  for (const auto& [weight, door] : doubtful) doors.push_back(door);
  return doors;
}

namespace {

/// The room of a withdrawn loop, where it was predicted.
void make_room_of(TopoState& state, const LoopClosure& closure) {
  Room room = closure.instead;
  room.T_map_room = get_room(state, closure.link.from).T_map_room * closure.link.T_from_to;
  const RoomId id = insert_room(state, room);
  RoomLink link = closure.link;
  link.to = id;
  state.map.links.push_back(link);
  Door& door = get_door(state, closure.door);
  door.kind = DoorKind::kPassage;
  door.other_face = DoorFace{.room = id, .gap = closure.entrance};
  door.thickness_m.reset();
  door.driven = true;
  for (const WallInterval& gap : closure.gaps)
    state.map.doors.push_back({.id = ++state.session.last_door, .face = {.room = id, .gap = gap}});
  Session& session = state.session;
  if (session.zone.room == closure.room && session.zone.via_door == closure.door) {
    move_zone(session, get_room(state, closure.room).T_map_room, room.T_map_room);
    session.zone.room = id;
    session.reference = room.rectangle();
  }
}

}  // namespace

void withdraw(TopoState& state, DoorId door) {
  std::vector<LoopClosure>& closures = state.session.closures;
  const auto it =
      std::find_if(closures.begin(), closures.end(), [door](const LoopClosure& c) { return c.door == door; });
  if (it == closures.end()) return split_door(state, door);
  const LoopClosure closure = *it;
  closures.erase(it);
  std::erase_if(state.map.doors, [&](const Door& d) {
    return std::find(closure.added.begin(), closure.added.end(), d.id) != closure.added.end() &&
           d.kind == DoorKind::kUnresolved;
  });
  make_room_of(state, closure);
}

}  // namespace enfilade::topo_graph
