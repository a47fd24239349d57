// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/graph_edit.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace enfilade::topo_graph {
namespace {

template <class T>
T& get_by_id(std::vector<T>& items, std::uint32_t id) {
  const auto it = std::find_if(items.begin(), items.end(), [id](const T& item) { return item.id == id; });
  if (it == items.end()) throw std::logic_error("no node or edge " + std::to_string(id) + " in the graph");
  return *it;
}

bool is_half_known(const Door& door) { return door.kind == DoorKind::kUnresolved && !door.other_face; }

bool overlap(const WallInterval& a, const WallInterval& b) {
  return a.wall == b.wall && interval_iou(a.from_m, a.to_m, b.from_m, b.to_m) > 0.0;
}

const Door* find_door_at(const TopologicalMap& map, RoomId room, const WallInterval& gap) {
  for (const Door& door : map.doors) {
    const DoorFace* face = TopologicalMap::find_face(door, room);
    if (face && overlap(face->gap, gap)) return &door;
  }
  return nullptr;
}

/// The unresolved door of another room whose face can be the other side of `face`, where only one can.
Door* find_other_side(TopoState& state, RoomId room, const PlacedFace& face, const FaceMatchConfig& match) {
  Door* found = nullptr;
  for (Door& door : state.map.doors) {
    if (!is_half_known(door) || door.face.room == room) continue;
    if (!coincide(place(get_room(state, door.face.room), door.face), face, match)) continue;
    if (found) return nullptr;
    found = &door;
  }
  return found;
}

/// A half-known door of `room`, other than `door`, where `gap` is.
std::optional<DoorFace> take_duplicate(TopoState& state, DoorId door, RoomId room, const WallInterval& gap,
                                       const FaceMatchConfig& match) {
  const Point2 middle = place(get_room(state, room).rectangle(), gap).midpoint();
  for (auto it = state.map.doors.begin(); it != state.map.doors.end(); ++it) {
    if (it->id == door || !is_half_known(*it) || it->face.room != room || !overlap(it->face.gap, gap))
      continue;
    const DoorFace face = it->face;
    if ((place(get_room(state, room), face).midpoint() - middle).norm() > match.max_distance_m) continue;
    state.map.doors.erase(it);
    return face;
  }
  return std::nullopt;
}

}  // namespace

Room& get_room(TopoState& state, RoomId id) { return get_by_id(state.map.rooms, id); }
Door& get_door(TopoState& state, DoorId id) { return get_by_id(state.map.doors, id); }

RoomId insert_room(TopoState& state, Room room) {
  room.id = ++state.session.last_room;
  room.name = "room " + std::to_string(room.id);
  state.map.rooms.push_back(std::move(room));
  return state.session.last_room;
}

DoorEdit add_door(TopoState& state, RoomId room, const WallInterval& gap, const DoorEstimate& seen,
                  const FaceMatchConfig& match) {
  if (const Door* present = find_door_at(state.map, room, gap)) return {present->id, false, false};
  const DoorFace face{.room = room, .gap = gap, .position_sigma_m = seen.position_sigma_m};
  if (Door* other = find_other_side(state, room, place(get_room(state, room), face), match)) {
    other->kind = DoorKind::kPassage;
    other->other_face = face;
    if (!other->height_m) other->height_m = seen.height_m;
    return {other->id, false, true};
  }
  Door door{.id = ++state.session.last_door, .face = face};
  door.height_m = seen.height_m;
  state.map.doors.push_back(door);
  return {door.id, true, false};
}

void join_door(TopoState& state, DoorId door, RoomId room, const WallInterval& gap,
               const FaceMatchConfig& match) {
  const std::optional<DoorFace> duplicate = take_duplicate(state, door, room, gap, match);
  Door& joined = get_door(state, door);
  joined.kind = DoorKind::kPassage;
  joined.other_face = duplicate ? *duplicate : DoorFace{room, gap};
}

std::optional<RoomId> find_room_at(const TopologicalMap& map, const Point2& p_map, RoomId except,
                                   double margin_m) {
  for (const Room& room : map.rooms) {
    if (room.id != except && room.rectangle().contains(p_map, margin_m)) return room.id;
  }
  return std::nullopt;
}

void split_door(TopoState& state, DoorId id) {
  Door& door = get_door(state, id);
  if (!door.other_face) return;
  const Door apart{.id = ++state.session.last_door, .face = *door.other_face, .height_m = door.height_m};
  door.kind = DoorKind::kUnresolved;
  door.other_face.reset();
  door.thickness_m.reset();
  door.measured_thickness_m.reset();
  door.driven = false;
  state.map.doors.push_back(apart);
}

}  // namespace enfilade::topo_graph
