// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/merge/map_merge.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "components/topoGraph/merge/map_alignment.hpp"

namespace enfilade::topo_graph {
namespace {

/// What a room of b is called from now on.
struct NewHome {
  RoomId id = 0;
  int turns = 0;  ///< see CommonRoom
  bool common = false;
};

class MapJoiner {
 public:
  MapJoiner(const TopologicalMap& a, const TopologicalMap& b, const MapAlignment& way,
            const MapMergeConfig& config)
      : config_(config), b_(b), way_(way), result_{.map = a, .T_a_b = way.T_a_b} {}

  MergedMaps join() {
    for (const CommonRoom& c : way_.common) {
      homes_[b_.rooms[c.in_b].id] = {result_.map.rooms[c.in_a].id, c.turns, true};
      result_.common.emplace_back(result_.map.rooms[c.in_a].id, b_.rooms[c.in_b].id);
    }
    for (const Room& room : b_.rooms)
      if (!homes_.count(room.id)) add_room(room);
    for (const Door& door : b_.doors) add_door(door);
    for (const RoomLink& link : b_.links) add_link(link);
    result_.map.version = std::max(result_.map.version, b_.version) + 1;
    result_.map.stamp_ns = std::max(result_.map.stamp_ns, b_.stamp_ns);
    return std::move(result_);
  }

 private:
  template <class Items>
  static std::uint32_t next_id(const Items& items) {
    return items.empty() ? 1 : items.back().id + 1;
  }

  void add_room(Room room) {
    const RoomId id = next_id(result_.map.rooms);
    homes_[room.id] = {.id = id};
    if (room.name == "room " + std::to_string(room.id)) room.name = "room " + std::to_string(id);
    const auto taken = [this](const std::string& name) {
      return std::any_of(result_.map.rooms.begin(), result_.map.rooms.end(),
                         [&name](const Room& other) { return other.name == name; });
    };
    for (int number = 2; taken(room.name); ++number) {
      const std::string longer = room.name + " (" + std::to_string(number) + ")";
      if (!taken(longer)) room.name = longer;
    }
    room.id = id;
    room.place = result_.map.find_room(result_.common.front().first)->place;
    room.T_map_room = way_.T_a_b * room.T_map_room;
    result_.map.rooms.push_back(std::move(room));
  }

  /// The face in the room's new home: for a common room the gap keeps its distance from the wall's middle.
  DoorFace moved(DoorFace face) const {
    const NewHome& home = homes_.at(face.room);
    const double length_b_m = b_.find_room(face.room)->rectangle().wall_length_m(face.gap.wall);
    face.room = home.id;
    if (!home.common) return face;
    face.gap.wall = static_cast<std::uint8_t>((face.gap.wall + home.turns) % 4);
    const double length_m = result_.map.find_room(home.id)->rectangle().wall_length_m(face.gap.wall);
    const double shift_m = 0.5 * (length_m - length_b_m);
    const double width_m = std::min(face.gap.width_m(), length_m);
    face.gap.from_m = std::clamp(face.gap.from_m + shift_m, 0.0, length_m - width_m);
    face.gap.to_m = face.gap.from_m + width_m;
    face.measured_offset_m.reset();
    return face;
  }

  Door* find_door(const DoorFace& face) {
    for (Door& door : result_.map.doors) {
      const DoorFace* known = TopologicalMap::find_face(door, face.room);
      if (known && known->gap.wall == face.gap.wall &&
          std::abs(known->gap.middle_m() - face.gap.middle_m()) <= config_.door_m)
        return &door;
    }
    return nullptr;
  }

  void add_door(Door door) {
    door.face = moved(door.face);
    if (door.other_face) door.other_face = moved(*door.other_face);
    Door* known = find_door(door.face);
    if (!known && door.other_face && (known = find_door(*door.other_face)))
      std::swap(door.face, *door.other_face);
    if (!known) {
      door.id = next_id(result_.map.doors);
      result_.map.doors.push_back(std::move(door));
      return;
    }
    if (known->other_face) return;
    if (known->kind == DoorKind::kUnresolved) known->kind = door.kind;
    if (!door.other_face) return;
    known->kind = DoorKind::kPassage;
    known->other_face = door.other_face;
    known->thickness_m = door.thickness_m;
    known->measured_thickness_m = door.measured_thickness_m;
    known->driven = door.driven;
    known->closed |= door.closed;
    if (!known->height_m) known->height_m = door.height_m;
  }

  void add_link(RoomLink link) {
    const NewHome &from = homes_.at(link.from), &to = homes_.at(link.to);
    if (from.common && to.common) return;
    const Pose2 from_turn{0, 0, 0.5 * kPi * from.turns}, to_turn{0, 0, 0.5 * kPi * to.turns};
    link.T_from_to = from_turn * link.T_from_to * to_turn.inverse();
    link.from = from.id;
    link.to = to.id;
    result_.map.links.push_back(link);
  }

  const MapMergeConfig& config_;
  const TopologicalMap& b_;
  const MapAlignment& way_;
  std::map<RoomId, NewHome> homes_;
  MergedMaps result_;
};

}  // namespace

MergedMaps merge_maps(const TopologicalMap& a, const TopologicalMap& b, const MapMergeConfig& config) {
  const MapAlignment way = align_maps(a, b, config);
  return MapJoiner(a, b, way, config).join();
}

}  // namespace enfilade::topo_graph
