// SPDX-License-Identifier: Apache-2.0
#include "tools/evaluate/graph/room_stream.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace enfilade::evaluate {
namespace {

using topo_graph::TopoGraph;

/// The robot: it knows the map's rooms and doors, the simulation knows where it truly is.
class Explorer {
 public:
  Explorer(const TrueBuilding& building, const StreamNoise& noise, const topo_graph::GraphConfig& config,
           std::uint64_t seed)
      : building_(building), noise_(noise), random_(seed), graph_(config, topo_graph::first_state(0)) {
    robot_ = building.rooms[0].pose();
    T_odom_true_ = robot_.inverse();
  }

  StreamResult run() {
    model_room();
    for (int crossings = 0; crossings < 40 * static_cast<int>(building_.rooms.size()); ++crossings) {
      const auto door = next_door();
      if (!door) break;
      cross(*door);
    }
    return result();
  }

 private:
  double normal(double sigma) { return sigma * std::normal_distribution<double>()(random_); }
  const topo_graph::TopoState& state() const { return graph_.state(); }
  CallId call() { return {"stream", ++calls_}; }

  RoomEstimate look(bool with_doors) {
    const std::size_t room = at_;
    RoomEstimate estimate;
    estimate.tag = {.zone_id = state().session.zone.zone_id, .grid_epoch = 1, .odom_boot = 1};
    estimate.stamp_ns = now_ns_ += from_seconds(10.0);
    estimate.found = true;
    estimate.unexplored_wall_share = 0.05;
    estimate.rectangle = T_odom_true_ * building_.rooms[room];
    Rectangle& seen = estimate.rectangle;
    seen.x_m += normal(noise_.centre_m);
    seen.y_m += normal(noise_.centre_m);
    seen.yaw_rad += normal(noise_.yaw_rad);
    seen.width_m += normal(noise_.size_m);
    seen.height_m += normal(noise_.size_m);
    if (with_doors) add_gaps(room, estimate);
    return estimate;
  }

  void add_gaps(std::size_t room, RoomEstimate& estimate) {
    const auto add = [&](WallInterval gap) {
      const double shift_m = normal(noise_.gap_m) + 0.5 * (estimate.rectangle.wall_length_m(gap.wall) -
                                                           building_.rooms[room].wall_length_m(gap.wall));
      gap.from_m = std::max(0.0, gap.from_m + shift_m);
      gap.to_m = std::min(estimate.rectangle.wall_length_m(gap.wall), gap.to_m + shift_m);
      estimate.doors.push_back({.gap = gap, .state = DoorState::kOpen, .position_sigma_m = noise_.gap_m});
    };
    for (const TrueDoor& door : building_.doors) {
      if (door.room_a == room) add(door.gap_a);
      if (door.room_b == room) add(door.gap_b);
    }
  }

  void model_room() {
    const auto outcome = graph_.fix_room({call(), look(true)}, ++now_ns_);
    stands_for_[outcome.reply.room].insert(at_);
    graph_.observe(look(false));
  }

  /// An unresolved door of this room, or the first step of the way to the nearest one.
  std::optional<DoorId> next_door() const {
    const RoomId here = *state().session.zone.room;
    std::map<RoomId, DoorId> first{{here, 0}};
    std::vector<RoomId> open{here};
    for (std::size_t i = 0; i < open.size(); ++i) {
      for (const Door& door : state().map.doors) {
        if (!TopologicalMap::find_face(door, open[i]) || tried_.count(door.id)) continue;
        const DoorId step = first[open[i]] == 0 ? door.id : first[open[i]];
        if (!door.other_face) return step;
        const RoomId beyond = door.face.room == open[i] ? door.other_face->room : door.face.room;
        if (first.emplace(beyond, step).second) open.push_back(beyond);
      }
    }
    return std::nullopt;
  }

  struct Behind {
    std::size_t room = 0;
    Point2 middle;  ///< of the door
  };

  /// The true door at which the robot goes through: the one of the true room nearest to where the map has it.
  std::optional<Behind> true_room_behind(DoorId id) const {
    const Door& door = *state().map.find_door(id);
    const RoomId here = *state().session.zone.room;
    const Room& room = *state().map.find_room(here);
    const Point2 middle = segment_in_map(room, *TopologicalMap::find_face(door, here)).midpoint();
    const Pose2 T_true_map = building_.rooms[at_].pose() * seen_pose(room).inverse();
    std::optional<Behind> behind;
    double nearest_m = 1.0;
    for (const TrueDoor& candidate : building_.doors) {
      if (candidate.room_a != at_ && candidate.room_b != at_) continue;
      const bool from_a = candidate.room_a == at_;
      const Point2 there =
          segment_of(building_.rooms[at_], from_a ? candidate.gap_a : candidate.gap_b).midpoint();
      const double away_m = (T_true_map * middle - there).norm();
      if (away_m >= nearest_m) continue;
      nearest_m = away_m;
      behind = Behind{from_a ? candidate.room_b : candidate.room_a, there};
    }
    return behind;
  }

  /// The map's pose of a room with its sides named as in the true building.
  Pose2 seen_pose(const Room& room) const {
    const Rectangle& truth = building_.rooms[at_];
    const double expected = wrap_to_pi(truth.yaw_rad - building_.rooms[0].yaw_rad);
    const double off = wrap_to_pi(room.T_map_room.yaw_rad - expected);
    return room.T_map_room * Pose2{0.0, 0.0, wrap_to_quarter(off) - off};
  }

  /// Odometry errs on the way from the door before to `middle`, where the robot then stands.
  void drive_through(const Point2& middle) {
    const double sigma_m = noise_.odometry_share * (middle - robot_.translation()).norm();
    const double yaw_rad = normal(noise_.odometry_yaw_rad) + noise_.yaw_bias_rad;
    const Pose2 error{normal(sigma_m), normal(sigma_m), yaw_rad};
    const Pose2 there{middle.x(), middle.y(), 0.0};
    T_odom_true_ = T_odom_true_ * there * error * there.inverse();
    robot_ = there;
  }

  void cross(DoorId id) {
    const auto behind = true_room_behind(id);
    if (!behind) {  // there is a wall: a door that the map has by mistake
      tried_.insert(id);
      return;
    }
    const RoomId from = *state().session.zone.room;
    drive_through(behind->middle);
    at_ = behind->room;
    const Pose2 T_zone_base = T_odom_true_ * robot_;
    graph_.enter_zone({call(), from, id, T_zone_base, ++now_ns_}, now_ns_);
    for (int i = 0; i < 4 && state().session.zone.room; ++i) graph_.observe(look(true));
    if (!state().session.zone.room) return model_room();
    stands_for_[*state().session.zone.room].insert(at_);
  }

  StreamResult result() const {
    StreamResult result{.state = state()};
    std::set<std::size_t> found;
    for (const Room& room : state().map.rooms) {
      const auto it = stands_for_.find(room.id);
      const std::set<std::size_t> rooms = it == stands_for_.end() ? std::set<std::size_t>{} : it->second;
      result.modelled.emplace_back(rooms.begin(), rooms.end());
      if (rooms.size() > 1) result.false_closures += static_cast<int>(rooms.size()) - 1;
      if (rooms.empty()) continue;
      if (!found.insert(*rooms.begin()).second) ++result.duplicates;
      const Pose2 truth = building_.rooms[0].pose().inverse() * building_.rooms[*rooms.begin()].pose();
      const Pose2 T_map_first = T_map_true_first();
      const Pose2 expected = T_map_first * truth;
      const double off_m = (room.T_map_room.translation() - expected.translation()).norm();
      const double off_rad = std::abs(wrap_to_quarter(room.T_map_room.yaw_rad - expected.yaw_rad));
      result.pose_error_max_m = std::max(result.pose_error_max_m, off_m);
      result.pose_error_max_rad = std::max(result.pose_error_max_rad, off_rad);
    }
    result.missed_rooms = static_cast<int>(building_.rooms.size() - found.size());
    return result;
  }

  Pose2 T_map_true_first() const { return state().map.rooms.front().T_map_room; }

  const TrueBuilding& building_;
  StreamNoise noise_;
  std::mt19937_64 random_;
  TopoGraph graph_;
  Pose2 T_odom_true_, robot_;
  std::size_t at_ = 0;
  StampNs now_ns_ = 1;
  std::uint64_t calls_ = 0;
  std::map<RoomId, std::set<std::size_t>> stands_for_;
  std::set<DoorId> tried_;
};

constexpr double kWallM = 0.15;

/// A door in the middle, plus `along_m`, of the wall `wall` of room a; room b lies beyond.
TrueDoor door_between(const TrueBuilding& building, std::size_t a, int wall, std::size_t b, double along_m) {
  const Rectangle &ra = building.rooms[a], &rb = building.rooms[b];
  const double middle_a = 0.5 * ra.wall_length_m(wall) + along_m;
  TrueDoor door{.room_a = a, .room_b = b};
  door.gap_a = {static_cast<std::uint8_t>(wall), middle_a - 0.45, middle_a + 0.45};
  const Point2 p = segment_of(ra, door.gap_a).midpoint();
  const Segment other = rb.wall((wall + 2) % 4);
  const double middle_b = (p - other.from).dot(other.direction());
  door.gap_b = {static_cast<std::uint8_t>((wall + 2) % 4), middle_b - 0.45, middle_b + 0.45};
  return door;
}

}  // namespace

StreamResult explore(const TrueBuilding& building, const StreamNoise& noise,
                     const topo_graph::GraphConfig& config, std::uint64_t seed) {
  return Explorer(building, noise, config, seed).run();
}

TrueBuilding office_corridor(int offices, int per_section) {
  constexpr double kOfficeX = 3.0, kOfficeY = 4.0, kCorridorY = 2.2;
  TrueBuilding building;
  const int a_side = per_section / 2;
  const double pitch_m = kOfficeX + kWallM, section_m = a_side * pitch_m;
  for (int section = 0; section * per_section < offices; ++section) {
    const double x_m = section_m * section;
    const std::size_t corridor = building.rooms.size();
    building.rooms.push_back({0.0, x_m, 0.0, section_m - kWallM, kCorridorY});
    if (section > 0) {
      std::size_t before = corridor - 1;
      while (building.rooms[before].height_m != kCorridorY) --before;
      building.doors.push_back(door_between(building, before, 0, corridor, 0.0));
    }
    for (int i = 0; i < std::min(per_section, offices - section * per_section); ++i) {
      const double side = i % 2 == 0 ? 1.0 : -1.0;
      const double along_m = (i / 2 - 0.5 * (a_side - 1)) * pitch_m;
      const std::size_t office = building.rooms.size();
      building.rooms.push_back(
          {0.0, x_m + along_m, side * (0.5 * (kCorridorY + kOfficeY) + kWallM), kOfficeX, kOfficeY});
      building.doors.push_back(
          door_between(building, corridor, i % 2 == 0 ? 1 : 3, office, i % 2 == 0 ? -along_m : along_m));
    }
  }
  return building;
}

TrueBuilding ring_of_rooms(int columns, int rows) {
  TrueBuilding building;
  std::vector<std::pair<int, int>> places;
  for (int i = 0; i < columns; ++i) places.emplace_back(i, 0);
  for (int i = 1; i < rows; ++i) places.emplace_back(columns - 1, i);
  for (int i = columns - 2; i >= 0; --i) places.emplace_back(i, rows - 1);
  for (int i = rows - 2; i >= 1; --i) places.emplace_back(0, i);
  for (const auto& [column, row] : places)
    building.rooms.push_back({0.0, 4.15 * column, 3.95 * row, 4.0, 3.8});
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t j = (i + 1) % places.size();
    const int dx = places[j].first - places[i].first, dy = places[j].second - places[i].second;
    const int wall = dx > 0 ? 0 : dy > 0 ? 1 : dx < 0 ? 2 : 3;
    building.doors.push_back(door_between(building, i, wall, j, 0.3 * static_cast<double>(i % 3) - 0.3));
  }
  return building;
}

}  // namespace enfilade::evaluate
