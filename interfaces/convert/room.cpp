// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/room.hpp"

namespace enfilade::wire {

namespace {

own::DoorEstimate_ estimate_to_wire(const DoorEstimate& door) {
  own::DoorEstimate_ out;
  out.gap(to_wire(door.gap));
  out.state(enum_to_wire(door.state));
  out.has_height(door.height_m.has_value());
  out.height_m(door.height_m.value_or(0.0));
  out.evidence().occupied_share(door.evidence.occupied_share);
  out.evidence().free_share(door.evidence.free_share);
  out.evidence().beyond_occupied_cells(door.evidence.beyond_occupied_cells);
  out.evidence().beyond_free_cells(door.evidence.beyond_free_cells);
  out.position_sigma_m(door.position_sigma_m);
  out.width_sigma_m(door.width_sigma_m);
  out.height_sigma_m(door.height_sigma_m);
  return out;
}

DoorEstimate estimate_from_wire(const own::DoorEstimate_& door) {
  const own::DoorEvidence_& seen = door.evidence();
  return {.gap = from_wire(door.gap()),
          .state = enum_from_wire(door.state(), DoorState::kUnexplored, "the state of a door"),
          .height_m = optional_from_wire(door.has_height(), door.height_m()),
          .evidence = {seen.occupied_share(), seen.free_share(), seen.beyond_occupied_cells(),
                       seen.beyond_free_cells()},
          .position_sigma_m = door.position_sigma_m(),
          .width_sigma_m = door.width_sigma_m(),
          .height_sigma_m = door.height_sigma_m()};
}

}  // namespace

own::WallInterval_ to_wire(const WallInterval& interval) {
  own::WallInterval_ out;
  out.wall(interval.wall);
  out.from_m(interval.from_m);
  out.to_m(interval.to_m);
  return out;
}

WallInterval from_wire(const own::WallInterval_& interval) {
  if (interval.wall() > 3)
    throw WireError("a gap lies in wall " + std::to_string(interval.wall()) + " of 0 to 3");
  return {interval.wall(), interval.from_m(), interval.to_m()};
}

own::RoomEstimate_ to_wire(const RoomEstimate& estimate) {
  own::RoomEstimate_ out;
  out.tag(to_wire(estimate.tag));
  out.grid_number(estimate.grid_sequence);
  out.stamp_ns(estimate.stamp_ns);
  out.found(estimate.found);
  out.rectangle(to_wire(estimate.rectangle));
  out.score(estimate.score);
  out.has_covariance(estimate.covariance.has_value());
  out.covariance(estimate.covariance.value_or(RectangleCovariance{}));
  out.outline(outline_to_wire(estimate.polygon));
  out.doors(each<own::DoorEstimate_>(estimate.doors, estimate_to_wire));
  out.unexplored_wall_share(estimate.unexplored_wall_share);
  out.has_recent(estimate.recent.has_value());
  out.recent(to_wire(estimate.recent.value_or(Rectangle{})));
  out.recent_stamp_ns(estimate.recent_stamp_ns);
  return out;
}

RoomEstimate from_wire(const own::RoomEstimate_& estimate) {
  check_count(estimate.doors().size(), kMaxDoors, "doors");
  return {.tag = from_wire(estimate.tag()),
          .grid_sequence = estimate.grid_number(),
          .stamp_ns = estimate.stamp_ns(),
          .found = estimate.found(),
          .rectangle = from_wire(estimate.rectangle()),
          .score = estimate.score(),
          .covariance = optional_from_wire(estimate.has_covariance(), estimate.covariance()),
          .polygon = outline_from_wire(estimate.outline()),
          .doors = each<DoorEstimate>(estimate.doors(), estimate_from_wire),
          .unexplored_wall_share = estimate.unexplored_wall_share(),
          .recent = optional_from_wire(estimate.has_recent(), from_wire(estimate.recent())),
          .recent_stamp_ns = estimate.recent_stamp_ns()};
}

}  // namespace enfilade::wire
