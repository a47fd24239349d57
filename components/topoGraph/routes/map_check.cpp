// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/routes/map_check.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "components/topoGraph/merge/map_alignment.hpp"

namespace enfilade::topo_graph {
namespace {

class MapChecker {
 public:
  MapChecker(const TopologicalMap& map, const MapCheckConfig& config) : map_(map), config_(config) {}

  std::vector<std::string> check() {
    for (const Room& room : map_.rooms) check_sizes(room);
    check_overlaps();
    for (const Door& door : map_.doors) {
      if (door.other_face) check_faces(door);
      if (door.kind == DoorKind::kUnresolved) check_behind(door);
    }
    check_gaps();
    check_reach();
    return std::move(found_);
  }

 private:
  template <class... Values>
  void tell(fmt::format_string<Values...> text, Values&&... values) {
    found_.push_back(fmt::format(text, std::forward<Values>(values)...));
  }

  void check_sizes(const Room& room) {
    const double least = std::min(room.width_m, room.height_m), most = std::max(room.width_m, room.height_m);
    if (least < config_.min_side_m || most > config_.max_side_m)
      tell("room {} is {:.2f} × {:.2f} m: no room has such a size", room.id, room.width_m, room.height_m);
    const double reach_m = 0.5 * std::hypot(room.width_m, room.height_m) + config_.max_side_m;
    for (const Point2& p : room.polygon) {
      if (p.norm() <= reach_m) continue;
      tell("room {} has an outline that reaches {:.0f} m from its middle", room.id, p.norm());
      return;
    }
  }

  /// By their left ends, so that only rooms near each other are compared.
  void check_overlaps() {
    struct Span {
      double from, to;
      const Room* room;
    };
    std::vector<Span> spans;
    for (const Room& room : map_.rooms) {
      const auto corners = room.rectangle().corners();
      const auto [left, right] = std::minmax_element(
          corners.begin(), corners.end(), [](const Point2& a, const Point2& b) { return a.x() < b.x(); });
      spans.push_back({left->x(), right->x(), &room});
    }
    std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.from < b.from; });
    std::vector<std::pair<RoomId, RoomId>> pairs;
    for (std::size_t i = 0; i < spans.size(); ++i) {
      for (std::size_t k = i + 1; k < spans.size() && spans[k].from < spans[i].to; ++k) {
        const Room& a = *spans[i].room;
        const Room& b = *spans[k].room;
        if (a.place == b.place && depth_of_overlap(a.rectangle(), b.rectangle()) > config_.overlap_m)
          pairs.push_back(std::minmax(a.id, b.id));
      }
    }
    std::sort(pairs.begin(), pairs.end());
    for (const auto& [a, b] : pairs)
      tell("rooms {} and {} overlap by {:.2f} m", a, b,
           depth_of_overlap(map_.find_room(a)->rectangle(), map_.find_room(b)->rectangle()));
  }

  void check_faces(const Door& door) {
    if (door.face.room == door.other_face->room) {
      tell("door {} joins room {} with itself", door.id, door.face.room);
      return;
    }
    const Room* a = map_.find_room(door.face.room);
    const Room* b = map_.find_room(door.other_face->room);
    if (!a || !b) return tell("door {} belongs to a room that is not in the map", door.id);
    const Point2 normal = a->rectangle().normal(door.face.gap.wall);
    const Point2 other = b->rectangle().normal(door.other_face->gap.wall);
    const double angle = std::acos(std::clamp(-normal.dot(other), -1.0, 1.0));
    const Point2 gap =
        segment_in_map(*b, *door.other_face).midpoint() - segment_in_map(*a, door.face).midpoint();
    const double across_m = gap.dot(normal), along_m = (gap - across_m * normal).norm();
    if (angle > config_.max_angle_rad)
      return tell("door {}: its walls in rooms {} and {} miss facing each other by {:.0f}°", door.id, a->id,
                  b->id, degrees(angle));
    if (along_m > config_.max_along_m || across_m < -config_.overlap_m || across_m > config_.max_thickness_m)
      tell("door {}: its faces in rooms {} and {} lie {:.2f} m apart along the wall and {:.2f} m across it",
           door.id, a->id, b->id, along_m, across_m);
  }

  void check_behind(const Door& door) {
    const Room* room = map_.find_room(door.face.room);
    if (!room) return tell("door {} belongs to a room that is not in the map", door.id);
    const Point2 beyond = segment_in_map(*room, door.face).midpoint() +
                          config_.beyond_m * room->rectangle().normal(door.face.gap.wall);
    for (const Room& other : map_.rooms) {
      if (other.id == room->id || other.place != room->place || !other.rectangle().contains(beyond)) continue;
      tell("door {} of room {} is unmatched: it leads into room {}, which has no such door", door.id,
           room->id, other.id);
    }
  }

  void check_gaps() {
    struct Gap {
      const DoorFace* face;
      DoorId door;
    };
    std::vector<Gap> gaps;
    for (const Door& door : map_.doors) {
      gaps.push_back({&door.face, door.id});
      if (door.other_face) gaps.push_back({&*door.other_face, door.id});
    }
    const auto key = [](const Gap& g) {
      return std::tuple(g.face->room, g.face->gap.wall, g.face->gap.from_m, g.door);
    };
    std::sort(gaps.begin(), gaps.end(), [&](const Gap& a, const Gap& b) { return key(a) < key(b); });
    for (std::size_t i = 0; i + 1 < gaps.size(); ++i) {
      const DoorFace &a = *gaps[i].face, &b = *gaps[i + 1].face;
      const bool one_wall = a.room == b.room && a.gap.wall == b.gap.wall;
      if (one_wall && b.gap.from_m < a.gap.to_m - config_.overlap_m)
        tell("doors {} and {} lie over one another in wall {} of room {}", gaps[i].door, gaps[i + 1].door,
             int{a.gap.wall}, a.room);
    }
  }

  void check_reach() {
    if (map_.rooms.empty()) return;
    std::map<RoomId, std::vector<RoomId>> neighbours;
    for (const Door& door : map_.doors) {
      if (door.kind != DoorKind::kPassage || !door.other_face) continue;
      neighbours[door.face.room].push_back(door.other_face->room);
      neighbours[door.other_face->room].push_back(door.face.room);
    }
    std::vector<RoomId> todo{map_.rooms.front().id};
    std::map<RoomId, bool> reached{{todo.front(), true}};
    while (!todo.empty()) {
      const RoomId room = todo.back();
      todo.pop_back();
      for (const RoomId next : neighbours[room])
        if (!std::exchange(reached[next], true)) todo.push_back(next);
    }
    for (const Room& room : map_.rooms)
      if (!reached[room.id])
        tell("room {} cannot be reached from room {}: no passage leads there", room.id,
             map_.rooms.front().id);
  }

  const TopologicalMap& map_;
  const MapCheckConfig& config_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> check_map(const TopologicalMap& map, const MapCheckConfig& config) {
  return MapChecker(map, config).check();
}

}  // namespace enfilade::topo_graph
