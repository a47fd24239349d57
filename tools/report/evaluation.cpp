// SPDX-License-Identifier: Apache-2.0
#include "tools/report/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace enfilade::report {
namespace {

using simulator::WorldTruth;

constexpr double kRoomIou = 0.5;
constexpr double kDoorIou = 0.4;
constexpr double kSameWall_m = 0.35;
const double kParallel = std::cos(radians(20.0));

struct Pair {
  double score;
  std::size_t found, truth;
};

/// Greedy one-to-one assignment, best scores first.
std::vector<std::optional<std::size_t>> assign(std::vector<Pair> pairs, std::size_t found_count) {
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.score > b.score; });
  std::vector<std::optional<std::size_t>> truth_of(found_count);
  std::set<std::size_t> taken;
  for (const Pair& pair : pairs) {
    if (truth_of[pair.found] || !taken.insert(pair.truth).second) continue;
    truth_of[pair.found] = pair.truth;
  }
  return truth_of;
}

/// The true rectangle with its sides named as those of `measured`: turned by the quarter turns that bring the
/// yaws together.
Rectangle named_like(const Rectangle& measured, Rectangle truth) {
  const double turn = std::round((measured.yaw_rad - truth.yaw_rad) / (0.5 * kPi));
  truth.yaw_rad = wrap_to_pi(truth.yaw_rad + turn * 0.5 * kPi);
  if (std::fmod(std::abs(turn), 2.0) == 1.0) std::swap(truth.width_m, truth.height_m);
  return truth;
}

Segment opening_of(const TopologicalMap& map, const Door& door, const Pose2& T_world_map) {
  const auto face_in_world = [&](const DoorFace& face) {
    const Room* room = map.find_room(face.room);
    return room ? T_world_map * segment_in_map(*room, face) : Segment{};
  };
  const Segment first = face_in_world(door.face);
  if (!door.other_face) return first;
  const Segment other =
      face_in_world(*door.other_face);  // runs the other way: both rooms count counter-clockwise
  return {0.5 * (first.from + other.to), 0.5 * (first.to + other.from)};
}

/// Interval IoU of two openings in one wall; 0 in different walls.
double door_overlap(const Segment& found, const Segment& truth) {
  const Point2 along = truth.direction();
  if (found.length() < 1e-9 || std::abs(found.direction().dot(along)) < kParallel) return 0.0;
  const Point2 normal(-along.y(), along.x());
  if (std::abs((found.midpoint() - truth.midpoint()).dot(normal)) > kSameWall_m) return 0.0;
  const double a = (found.from - truth.from).dot(along), b = (found.to - truth.from).dot(along);
  return interval_iou(std::min(a, b), std::max(a, b), 0.0, truth.length());
}

std::vector<RoomReport> rooms_in_world(const TopologicalMap& map, const WorldTruth& truth) {
  std::vector<RoomReport> rooms;
  std::vector<Pair> pairs;
  for (const Room& room : map.rooms) {
    RoomReport report{.id = room.id, .measured = canonical(truth.T_world_start * room.rectangle()).rectangle};
    for (const Door& door : map.doors) {
      if (TopologicalMap::find_face(door, room.id)) report.doors.push_back(door.id);
    }
    for (std::size_t t = 0; t < truth.rooms.size(); ++t) {
      const double overlap = iou(report.measured, truth.rooms[t].rectangle);
      if (overlap >= kRoomIou) pairs.push_back({overlap, rooms.size(), t});
    }
    rooms.push_back(std::move(report));
  }
  const auto truth_of = assign(pairs, rooms.size());
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    if (!truth_of[i]) continue;
    rooms[i].truth_index = truth_of[i];
    rooms[i].truth = named_like(rooms[i].measured, truth.rooms[*truth_of[i]].rectangle);
    rooms[i].iou = iou(rooms[i].measured, *rooms[i].truth);
  }
  return rooms;
}

std::vector<DoorReport> doors_in_world(const TopologicalMap& map, const WorldTruth& truth) {
  std::vector<DoorReport> doors;
  std::vector<Pair> pairs;
  for (const Door& door : map.doors) {
    DoorReport report{.id = door.id, .kind = door.kind, .rooms = {door.face.room}};
    if (door.other_face) report.rooms.push_back(door.other_face->room);
    report.opening = opening_of(map, door, truth.T_world_start);
    for (std::size_t t = 0; t < truth.doors.size(); ++t) {
      const double overlap = door_overlap(report.opening, truth.doors[t].opening);
      if (overlap > kDoorIou) pairs.push_back({overlap, doors.size(), t});
    }
    doors.push_back(std::move(report));
  }
  const auto truth_of = assign(pairs, doors.size());
  for (std::size_t i = 0; i < doors.size(); ++i) {
    doors[i].truth_index = truth_of[i];
    if (truth_of[i]) doors[i].truth = truth.doors[*truth_of[i]].opening;
  }
  return doors;
}

std::optional<double> mean(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

std::optional<double> share(std::size_t part, std::size_t whole) {
  if (whole == 0) return std::nullopt;
  return static_cast<double>(part) / static_cast<double>(whole);
}

Metrics metrics_of(const Evaluation& e, const WorldTruth& truth) {
  Metrics m{.rooms_found = static_cast<int>(e.rooms.size()), .doors_found = static_cast<int>(e.doors.size())};
  if (truth.rooms.empty()) return m;
  std::vector<double> ious, sizes, centres, door_shifts;
  for (const RoomReport& room : e.rooms) {
    if (!room.truth) continue;
    ious.push_back(room.iou);
    sizes.push_back(std::abs(room.measured.width_m - room.truth->width_m));
    sizes.push_back(std::abs(room.measured.height_m - room.truth->height_m));
    centres.push_back((room.measured.pose().translation() - room.truth->pose().translation()).norm());
  }
  for (const DoorReport& door : e.doors) {
    if (door.truth) door_shifts.push_back(door.shift_m());
  }
  m.rooms_true = static_cast<int>(truth.rooms.size());
  m.doors_true = static_cast<int>(truth.doors.size());
  m.room_precision = share(ious.size(), e.rooms.size());
  m.room_recall = share(ious.size(), truth.rooms.size());
  m.door_precision = share(door_shifts.size(), e.doors.size());
  m.door_recall = share(door_shifts.size(), truth.doors.size());
  m.room_iou_mean = mean(ious);
  m.size_error_mean_m = mean(sizes);
  if (!sizes.empty()) m.size_error_max_m = *std::max_element(sizes.begin(), sizes.end());
  m.center_error_mean_m = mean(centres);
  m.door_error_mean_m = mean(door_shifts);
  return m;
}

}  // namespace

double DoorReport::shift_m() const {
  return std::abs((opening.midpoint() - truth->midpoint()).dot(truth->direction()));
}

Evaluation evaluate(const TopologicalMap& map, const WorldTruth& truth) {
  Evaluation e{.rooms = rooms_in_world(map, truth), .doors = doors_in_world(map, truth), .metrics = {}};
  e.metrics = metrics_of(e, truth);
  return e;
}

}  // namespace enfilade::report
