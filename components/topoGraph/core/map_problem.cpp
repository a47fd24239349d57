// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/map_problem.hpp"

#include <algorithm>
#include <cmath>

#include "interfaces/geometry/square.hpp"

namespace enfilade::topo_graph {
namespace {

/// σ of parameter `index` of (α, x_c, y_c, w, h).
double sigma_of(const Room& room, int index, double least) {
  if (!room.covariance) return least;
  return std::max(least, std::sqrt(std::max(0.0, (*room.covariance)[static_cast<std::size_t>(6 * index)])));
}

double measured_offset(const Room& room, const DoorFace& face) {
  return face.measured_offset_m.value_or(face.gap.middle_m() -
                                         0.5 * room.rectangle().wall_length_m(face.gap.wall));
}

RoomNode node_of(const Room& room, const UncertaintyConfig& config) {
  const Point2 size = room.measured_size_m.value_or(Point2(room.width_m, room.height_m));
  return {room.T_map_room, size.x(), size.y(), sigma_of(room, 3, config.size_m),
          sigma_of(room, 4, config.size_m)};
}

FaceNode face_of(const TopologicalMap& map, const DoorFace& face, const UncertaintyConfig& config) {
  const std::size_t index = *room_index(map, face.room);
  const double sigma = face.position_sigma_m > 0.0 ? face.position_sigma_m : config.door_position_m;
  return {index, face.gap.wall, measured_offset(map.rooms[index], face), std::max(sigma, 0.005)};
}

DoorFactor factor_of(const TopologicalMap& map, const Door& door, const WallKnowledge& walls,
                     const UncertaintyConfig& config) {
  DoorFactor factor{.a = face_of(map, door.face, config), .b = face_of(map, *door.other_face, config)};
  factor.thickness_m = door.measured_thickness_m.value_or(walls.thickness_m);
  factor.sigma_thickness_m = door.measured_thickness_m ? walls.crossing_sigma_m : walls.sigma_m;
  const double yaw_a = sigma_of(map.rooms[factor.a.room], 0, 0.0);
  const double yaw_b = sigma_of(map.rooms[factor.b.room], 0, 0.0);
  factor.sigma_direction_rad = std::hypot(config.door_direction_rad, yaw_a, yaw_b);
  factor.loop = !door.driven;
  return factor;
}

/// By how much odometry missed from room to room, as the doors tell (rms); `odometry_m` counts as one miss.
double odometry_miss_m(const TopologicalMap& map, const UncertaintyConfig& config) {
  double squares = square(config.odometry_m), count = 1.0;
  for (const RoomLink& link : map.links) {
    const Room *from = map.find_room(link.from), *to = map.find_room(link.to);
    const Pose2 T_from_to = from->T_map_room.inverse() * to->T_map_room;
    squares += (T_from_to.translation() - link.T_from_to.translation()).squaredNorm();
    count += 1.0;
  }
  return std::sqrt(squares / count);
}

/// Puts the gap where the solution has it, as far as its wall goes.
void move_gap(const Room& room, DoorFace& face, double measured_m, double offset_m) {
  face.measured_offset_m = measured_m;
  const double length_m = room.rectangle().wall_length_m(face.gap.wall);
  const double width_m = std::min(face.gap.width_m(), length_m);
  face.gap.from_m = std::clamp(offset_m + 0.5 * (length_m - width_m), 0.0, length_m - width_m);
  face.gap.to_m = face.gap.from_m + width_m;
}

}  // namespace

std::optional<std::size_t> room_index(const TopologicalMap& map, RoomId room) {
  const auto it = std::lower_bound(map.rooms.begin(), map.rooms.end(), room,
                                   [](const Room& r, RoomId id) { return r.id < id; });
  if (it == map.rooms.end() || it->id != room) return std::nullopt;
  return static_cast<std::size_t>(it - map.rooms.begin());
}

WallKnowledge wall_knowledge(const TopologicalMap& map, const UncertaintyConfig& config) {
  WallKnowledge walls;
  walls.crossing_sigma_m = std::hypot(config.crossing_sigma_m, odometry_miss_m(map, config));
  // The building's mean is normal about what is configured, each wall about the building's mean, each
  // measurement about its wall.
  const double of_one = square(config.thickness_spread_m) + square(walls.crossing_sigma_m);
  double information = 1.0 / square(config.thickness_sigma_m), sum = config.thickness_m * information;
  for (const Door& door : map.doors) {
    if (!door.measured_thickness_m) continue;
    information += 1.0 / of_one;
    sum += *door.measured_thickness_m / of_one;
  }
  walls.thickness_m = sum / information;
  walls.sigma_m = std::sqrt(1.0 / information + square(config.thickness_spread_m));
  return walls;
}

MapProblem map_problem(const TopologicalMap& map, const UncertaintyConfig& config) {
  MapProblem out;
  const WallKnowledge walls = wall_knowledge(map, config);
  for (const Room& room : map.rooms) out.problem.rooms.push_back(node_of(room, config));
  for (const Door& door : map.doors) {
    if (!door.other_face || door.other_face->room == door.face.room) continue;
    out.problem.doors.push_back(factor_of(map, door, walls, config));
    out.doors.push_back(door.id);
  }
  for (const RoomLink& link : map.links) {
    out.problem.odometry.push_back({*room_index(map, link.from), *room_index(map, link.to), link.T_from_to,
                                    link.sigma_position_m, link.sigma_yaw_rad});
  }
  return out;
}

void apply(const GraphSolution& solution, const MapProblem& from, TopologicalMap& map) {
  // A gap keeps its place relative to its wall's middle while the wall's length changes.
  std::vector<std::pair<double, double>> offsets;
  for (const Door& door : map.doors) {
    const auto offset = [&](const DoorFace& face) {
      return measured_offset(map.rooms[*room_index(map, face.room)], face);
    };
    offsets.emplace_back(offset(door.face), door.other_face ? offset(*door.other_face) : 0.0);
  }
  for (std::size_t i = 0; i < map.rooms.size(); ++i) {
    Room& room = map.rooms[i];
    room.measured_size_m = Point2(from.problem.rooms[i].width_m, from.problem.rooms[i].height_m);
    room.T_map_room = solution.rooms[i].T_map_room;
    room.width_m = solution.rooms[i].width_m;
    room.height_m = solution.rooms[i].height_m;
  }
  for (std::size_t i = 0, k = 0; i < map.doors.size(); ++i) {
    Door& door = map.doors[i];
    const bool solved = k < from.doors.size() && from.doors[k] == door.id;
    const double offset_a = solved ? solution.doors[k].offset_a_m : offsets[i].first;
    move_gap(map.rooms[*room_index(map, door.face.room)], door.face, offsets[i].first, offset_a);
    if (!door.other_face) continue;
    const double offset_b = solved ? solution.doors[k].offset_b_m : offsets[i].second;
    move_gap(map.rooms[*room_index(map, door.other_face->room)], *door.other_face, offsets[i].second,
             offset_b);
    if (solved) door.thickness_m = solution.doors[k++].thickness_m;
  }
}

}  // namespace enfilade::topo_graph
