// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/room.hpp"

namespace enfilade::wire {

namespace {

own::DoorFace_ face_to_wire(const DoorFace& face) {
  own::DoorFace_ out;
  out.room(face.room);
  out.gap(to_wire(face.gap));
  out.position_sigma_m(face.position_sigma_m);
  out.has_measured_offset(face.measured_offset_m.has_value());
  out.measured_offset_m(face.measured_offset_m.value_or(0.0));
  return out;
}

DoorFace face_from_wire(const own::DoorFace_& face) {
  return {face.room(), from_wire(face.gap()), face.position_sigma_m(),
          optional_from_wire(face.has_measured_offset(), face.measured_offset_m())};
}

own::Door_ door_to_wire(const Door& door) {
  own::Door_ out;
  out.id(door.id);
  out.kind(enum_to_wire(door.kind));
  out.face(face_to_wire(door.face));
  out.has_other_face(door.other_face.has_value());
  out.other_face(face_to_wire(door.other_face.value_or(DoorFace{})));
  out.has_height(door.height_m.has_value());
  out.height_m(door.height_m.value_or(0.0));
  out.has_thickness(door.thickness_m.has_value());
  out.thickness_m(door.thickness_m.value_or(0.0));
  out.has_measured_thickness(door.measured_thickness_m.has_value());
  out.measured_thickness_m(door.measured_thickness_m.value_or(0.0));
  out.driven(door.driven);
  out.closed(door.closed);
  return out;
}

Door door_from_wire(const own::Door_& door) {
  return {
      .id = door.id(),
      .kind = enum_from_wire(door.kind(), DoorKind::kBlocked, "the kind of a door"),
      .face = face_from_wire(door.face()),
      .other_face = optional_from_wire(door.has_other_face(), face_from_wire(door.other_face())),
      .height_m = optional_from_wire(door.has_height(), door.height_m()),
      .thickness_m = optional_from_wire(door.has_thickness(), door.thickness_m()),
      .measured_thickness_m = optional_from_wire(door.has_measured_thickness(), door.measured_thickness_m()),
      .driven = door.driven(),
      .closed = door.closed()};
}

own::Room_ room_to_wire(const Room& room) {
  own::Room_ out;
  out.id(room.id);
  out.name(room.name);
  out.pose_map_room(to_wire(room.T_map_room));
  out.width_m(room.width_m);
  out.height_m(room.height_m);
  out.has_measured_size(room.measured_size_m.has_value());
  out.measured_width_m(room.measured_size_m.value_or(Point2::Zero()).x());
  out.measured_height_m(room.measured_size_m.value_or(Point2::Zero()).y());
  out.has_covariance(room.covariance.has_value());
  out.covariance(room.covariance.value_or(RectangleCovariance{}));
  out.outline(outline_to_wire(room.polygon));
  out.zone_id(room.zone_id);
  out.fixed_ns(room.fixed_ns);
  out.seen_ns(room.seen_ns);
  out.has_pose_room_base(room.T_room_base.has_value());
  out.pose_room_base(to_wire(room.T_room_base.value_or(Pose2{})));
  out.place(room.place);
  return out;
}

Room room_from_wire(const own::Room_& room) {
  return {.id = room.id(),
          .name = checked(room.name()),
          .T_map_room = from_wire(room.pose_map_room()),
          .width_m = room.width_m(),
          .height_m = room.height_m(),
          .measured_size_m = optional_from_wire(room.has_measured_size(),
                                                Point2(room.measured_width_m(), room.measured_height_m())),
          .covariance = optional_from_wire(room.has_covariance(), room.covariance()),
          .polygon = outline_from_wire(room.outline()),
          .zone_id = room.zone_id(),
          .fixed_ns = room.fixed_ns(),
          .seen_ns = room.seen_ns(),
          .T_room_base = optional_from_wire(room.has_pose_room_base(), from_wire(room.pose_room_base())),
          .place = room.place()};
}

own::RoomLink_ link_to_wire(const RoomLink& link) {
  own::RoomLink_ out;
  out.from_room(link.from);
  out.to_room(link.to);
  out.pose_from_to(to_wire(link.T_from_to));
  out.sigma_position_m(link.sigma_position_m);
  out.sigma_yaw_rad(link.sigma_yaw_rad);
  return out;
}

RoomLink link_from_wire(const own::RoomLink_& link) {
  return {link.from_room(), link.to_room(), from_wire(link.pose_from_to()), link.sigma_position_m(),
          link.sigma_yaw_rad()};
}

own::Place_ place_to_wire(const Place& place) {
  own::Place_ out;
  out.id(place.id);
  out.parent(place.parent);
  out.kind(enum_to_wire(place.kind));
  out.name(place.name);
  return out;
}

Place place_from_wire(const own::Place_& place) {
  return {place.id(), place.parent(), enum_from_wire(place.kind(), PlaceKind::kFloor, "the kind of a place"),
          checked(place.name())};
}

}  // namespace

own::TopologicalMap_ to_wire(const TopologicalMap& map) {
  own::TopologicalMap_ out;
  out.version(map.version);
  out.stamp_ns(map.stamp_ns);
  out.rooms(each<own::Room_>(map.rooms, room_to_wire));
  out.doors(each<own::Door_>(map.doors, door_to_wire));
  out.links(each<own::RoomLink_>(map.links, link_to_wire));
  out.places(each<own::Place_>(map.places, place_to_wire));
  return out;
}

TopologicalMap from_wire(const own::TopologicalMap_& map) {
  check_count(map.rooms().size(), kMaxRooms, "rooms");
  check_count(map.doors().size(), kMaxDoors, "doors");
  check_count(map.links().size(), kMaxLinks, "links");
  check_count(map.places().size(), kMaxRooms, "places");
  return {map.version(),
          map.stamp_ns(),
          each<Room>(map.rooms(), room_from_wire),
          each<Door>(map.doors(), door_from_wire),
          each<RoomLink>(map.links(), link_from_wire),
          each<Place>(map.places(), place_from_wire)};
}

}  // namespace enfilade::wire
