// SPDX-License-Identifier: Apache-2.0
#include "interfaces/model/topological_map.hpp"

#include <algorithm>

namespace enfilade {
namespace {

template <class T>
const T* find_by_id(const std::vector<T>& items, std::uint32_t id) {
  if (id > 0 && id <= items.size() && items[id - 1].id == id) return &items[id - 1];  // none was ever removed
  const auto it = std::find_if(items.begin(), items.end(), [id](const T& item) { return item.id == id; });
  return it == items.end() ? nullptr : &*it;
}

}  // namespace

const Room* TopologicalMap::find_room(RoomId id) const { return find_by_id(rooms, id); }
const Door* TopologicalMap::find_door(DoorId id) const { return find_by_id(doors, id); }

const DoorFace* TopologicalMap::find_face(const Door& door, RoomId room) {
  if (door.face.room == room) return &door.face;
  return door.other_face && door.other_face->room == room ? &*door.other_face : nullptr;
}

Segment segment_in_map(const Room& room, const DoorFace& face) {
  return segment_of(room.rectangle(), face.gap);
}

}  // namespace enfilade
