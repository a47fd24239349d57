// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <string>

#include "components/topoGraph/core/topo_state.hpp"

namespace enfilade::topo_graph::test {

/// A state that can be in a map file and changes at random, in all the ways in which one can change.
class RandomState {
 public:
  explicit RandomState(std::uint64_t seed) : random_(seed), state_(first_state(0)) {}

  const TopoState& state() const { return state_; }

  void reset_to(TopoState state) { state_ = std::move(state); }

  /// One to three edits.
  const TopoState& change() {
    for (std::uint64_t edits = 1 + below(3); edits > 0; --edits) edit();
    state_.map.version += below(2);
    state_.map.stamp_ns += static_cast<StampNs>(below(1000));
    return state_;
  }

 private:
  std::uint64_t below(std::uint64_t end) { return random_() % end; }
  double real() { return std::uniform_real_distribution<double>(-5.0, 5.0)(random_); }
  Pose2 pose() { return {real(), real(), real()}; }
  template <class Items>
  auto& any_of(Items& items) {
    return items[below(items.size())];
  }

  template <class Items>
  void drop_one(Items& items) {
    items.erase(items.begin() + static_cast<std::ptrdiff_t>(below(items.size())));
  }

  void edit() {
    TopologicalMap& map = state_.map;
    if (map.rooms.empty() || below(4) == 0) return add_room();
    switch (below(9)) {
      case 0:
        return remove_room();
      case 1:
        return move_room(any_of(map.rooms));
      case 2:
        return add_door();
      case 3:
        return map.doors.empty() ? add_door() : change_door(any_of(map.doors));
      case 4:
        return add_link();
      case 5:
        return map.links.empty() ? add_link() : drop_one(map.links);
      case 6:
        return add_closure();
      case 7:
        return add_place();
      default:
        return answer();
    }
  }

  void add_room() {
    Room room{.id = ++state_.session.last_room, .name = "room \"" + std::to_string(below(1000)) + "\"\n"};
    room.width_m = 3.0 + real() / 5.0;
    room.height_m = 4.0;
    room.zone_id = ++state_.session.zone.zone_id;
    room.place = 2;
    if (below(2)) room.covariance.emplace().fill(real());
    if (below(3) == 0) room.polygon = {{real(), real()}, {real(), real()}, {real(), real()}};
    move_room(room);
    state_.map.rooms.push_back(room);
    state_.session.zone.room = room.id;
    state_.session.reference = room.rectangle();
  }

  void move_room(Room& room) {
    room.T_map_room = pose();
    room.seen_ns = static_cast<StampNs>(below(1000));
    room.measured_size_m = Point2(real(), real());
    room.T_room_base = pose();
    state_.session.zone.T_map_zone = pose();
  }

  /// With all that is told of it.
  void remove_room() {
    const RoomId id = any_of(state_.map.rooms).id;
    const auto of_it = [id](const auto& item) { return item.from == id || item.to == id; };
    std::erase_if(state_.map.rooms, [id](const Room& room) { return room.id == id; });
    std::erase_if(state_.map.links, of_it);
    Session& session = state_.session;
    const auto has_it = [id](const Door& door) { return TopologicalMap::find_face(door, id) != nullptr; };
    std::erase_if(state_.map.doors, has_it);
    std::erase_if(session.closures, [this, id](const LoopClosure& closure) {
      return closure.room == id || closure.link.from == id || !state_.map.find_door(closure.door);
    });
    if (session.zone.room == id) {
      session.zone.room.reset();
      session.reference.reset();
    }
    if (session.zone.via_door && !state_.map.find_door(*session.zone.via_door)) session.zone.via_door.reset();
  }

  DoorFace face() {
    const double from_m = 0.5 + static_cast<double>(below(10)) / 10.0;
    return {any_of(state_.map.rooms).id, {static_cast<std::uint8_t>(below(4)), from_m, from_m + 0.3}};
  }

  void add_door() {
    state_.map.doors.push_back({.id = ++state_.session.last_door, .face = face()});
    change_door(state_.map.doors.back());
    state_.session.zone.via_door = state_.map.doors.back().id;
  }

  void change_door(Door& door) {
    door.kind = static_cast<DoorKind>(below(4));
    door.other_face.reset();
    if (door.kind == DoorKind::kPassage) door.other_face = face();
    if (below(2)) door.thickness_m = 0.15;
    if (below(2)) door.height_m = 2.0 + real();
    door.driven = below(2) == 1;
    door.closed = below(2) == 1;
    door.face.position_sigma_m = static_cast<double>(below(3)) / 10.0;
    if (below(2)) door.face.measured_offset_m = real();
  }

  RoomLink link() { return {any_of(state_.map.rooms).id, any_of(state_.map.rooms).id, pose(), 0.1, 0.2}; }
  void add_link() { state_.map.links.push_back(link()); }

  void add_place() {
    const auto id = static_cast<PlaceId>(state_.map.places.size() + 1);
    state_.map.places.push_back({id, 1, PlaceKind::kFloor, "floor"});
    any_of(state_.map.places).name += "'";
  }

  void add_closure() {
    auto& closures = state_.session.closures;
    if (!closures.empty() && below(2)) return drop_one(closures);
    if (state_.map.doors.empty()) return add_door();
    LoopClosure closure{.door = any_of(state_.map.doors).id, .link = link()};
    closure.room = any_of(state_.map.rooms).id;
    closure.instead = any_of(state_.map.rooms);
    closure.instead.id = closure.link.to = 0;
    closure.entrance = {1, 0.5, 1.5};
    closure.gaps = {{2, 0.25, 0.75}};
    closure.added = {7, 8};
    closures.push_back(closure);
  }

  void answer() {
    const CallId call{"explorer", random_()};
    remember(state_.session, {call, static_cast<RequestKind>(below(3)), below(2) == 1, "why: not", 3}, 5);
  }

  std::mt19937_64 random_;
  TopoState state_;
};

}  // namespace enfilade::topo_graph::test
