// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/room.hpp"

namespace enfilade::wire {

namespace {

own::DoorFace_ face_to_wire(const DoorFace& face) {
  own::DoorFace_ out;
  out.room(face.room);
  out.gap(to_wire(face.gap));
  return out;
}

DoorFace face_from_wire(const own::DoorFace_& face) { return {face.room(), from_wire(face.gap())}; }

own::Door_ door_to_wire(const Door& door) {
  own::Door_ out;
  out.id(door.id);
  out.kind(enum_to_wire(door.kind));
  out.face(face_to_wire(door.face));
  out.has_other_face(door.other_face.has_value());
  out.other_face(face_to_wire(door.other_face.value_or(DoorFace{})));
  out.has_height(door.height_m.has_value());
  out.height_m(door.height_m.value_or(0.0));
  return out;
}

Door door_from_wire(const own::Door_& door) {
  return {.id = door.id(),
          .kind = enum_from_wire(door.kind(), DoorKind::kBlocked, "the kind of a door"),
          .face = face_from_wire(door.face()),
          .other_face = optional_from_wire(door.has_other_face(), face_from_wire(door.other_face())),
          .height_m = optional_from_wire(door.has_height(), door.height_m())};
}

own::Room_ room_to_wire(const Room& room) {
  own::Room_ out;
  out.id(room.id);
  out.name(room.name);
  out.pose_map_room(to_wire(room.T_map_room));
  out.width_m(room.width_m);
  out.height_m(room.height_m);
  out.has_covariance(room.covariance.has_value());
  out.covariance(room.covariance.value_or(RectangleCovariance{}));
  out.outline(outline_to_wire(room.polygon));
  out.zone_id(room.zone_id);
  out.fixed_ns(room.fixed_ns);
  return out;
}

Room room_from_wire(const own::Room_& room) {
  return {.id = room.id(),
          .name = checked(room.name()),
          .T_map_room = from_wire(room.pose_map_room()),
          .width_m = room.width_m(),
          .height_m = room.height_m(),
          .covariance = optional_from_wire(room.has_covariance(), room.covariance()),
          .polygon = outline_from_wire(room.outline()),
          .zone_id = room.zone_id(),
          .fixed_ns = room.fixed_ns()};
}

}  // namespace

own::TopologicalMap_ to_wire(const TopologicalMap& map) {
  own::TopologicalMap_ out;
  out.version(map.version);
  out.stamp_ns(map.stamp_ns);
  out.rooms(each<own::Room_>(map.rooms, room_to_wire));
  out.doors(each<own::Door_>(map.doors, door_to_wire));
  return out;
}

TopologicalMap from_wire(const own::TopologicalMap_& map) {
  check_count(map.rooms().size(), kMaxRooms, "rooms");
  check_count(map.doors().size(), kMaxDoors, "doors");
  return {map.version(), map.stamp_ns(), each<Room>(map.rooms(), room_from_wire),
          each<Door>(map.doors(), door_from_wire)};
}

}  // namespace enfilade::wire
