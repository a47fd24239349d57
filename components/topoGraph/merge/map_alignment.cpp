// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/merge/map_alignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace enfilade::topo_graph {
namespace {

using DoorPlaces = std::vector<std::vector<Point2>>;  ///< middles of each room's doors, map frame

DoorPlaces door_places(const TopologicalMap& map) {
  DoorPlaces places(map.rooms.size());
  const auto add = [&](const DoorFace& face) {
    for (std::size_t i = 0; i < map.rooms.size(); ++i)
      if (map.rooms[i].id == face.room) places[i].push_back(segment_in_map(map.rooms[i], face).midpoint());
  };
  for (const Door& door : map.doors) {
    add(door.face);
    if (door.other_face) add(*door.other_face);
  }
  return places;
}

int quarter_turns(double yaw_rad) {
  return static_cast<int>(std::lround(wrap_to_pi(yaw_rad) / (0.5 * kPi))) & 3;
}

class MapAligner {
 public:
  MapAligner(const TopologicalMap& a, const TopologicalMap& b, const MapMergeConfig& config)
      : a_(a), b_(b), config_(config), doors_a_(door_places(a)), doors_b_(door_places(b)) {}

  MapAlignment align() const {
    std::vector<MapAlignment> found;
    for (std::size_t i = 0; i < a_.rooms.size(); ++i)
      for (std::size_t k = 0; k < b_.rooms.size(); ++k)
        for (int turns = 0; turns < 4; ++turns)
          if (same_size(a_.rooms[i], b_.rooms[k], turns)) found.push_back(judge({i, k, turns}));
    const auto best =
        std::max_element(found.begin(), found.end(),
                         [](const MapAlignment& x, const MapAlignment& y) { return x.score < y.score; });
    if (best == found.end() || best->score < config_.enough)
      throw std::invalid_argument(
          "too little speaks for a room in common: it takes two by size, or one with two doors");
    for (const MapAlignment& other : found)
      if (other.score >= best->score - config_.margin && differ(*best, other))
        throw std::invalid_argument(
            "the maps fit together in more than one way; explore more of what both hold before merging");
    return *best;
  }

 private:
  bool same_size(const Room& a, const Room& b, int turns) const {
    const bool swapped = turns % 2 != 0;
    return std::abs(a.width_m - (swapped ? b.height_m : b.width_m)) <= config_.size_m &&
           std::abs(a.height_m - (swapped ? b.width_m : b.height_m)) <= config_.size_m;
  }

  MapAlignment judge(const CommonRoom& anchor) const {
    const Room& room = b_.rooms[anchor.in_b];
    MapAlignment way{.T_a_b = a_.rooms[anchor.in_a].T_map_room * Pose2{0, 0, 0.5 * kPi * anchor.turns} *
                              room.T_map_room.inverse()};
    for (std::size_t k = 0; k < b_.rooms.size(); ++k) {
      const double far_m = (b_.rooms[k].T_map_room.translation() - room.T_map_room.translation()).norm();
      const double reach_m = config_.distance_m + config_.distance_share * far_m;
      if (const auto common = find_common(way.T_a_b, k, reach_m)) {
        way.common.push_back(*common);
        way.score += 1.0 + judge_doors(way.T_a_b, *common, reach_m - config_.distance_m + config_.door_m);
      } else {
        way.score -= 2.0 * overlaps(way.T_a_b * b_.rooms[k].rectangle());
      }
    }
    way.T_a_b = fit(way);
    return way;
  }

  std::optional<CommonRoom> find_common(const Pose2& T_a_b, std::size_t k, double reach_m) const {
    const Pose2 T_a_room = T_a_b * b_.rooms[k].T_map_room;
    for (std::size_t i = 0; i < a_.rooms.size(); ++i) {
      const Room& room = a_.rooms[i];
      if ((room.T_map_room.translation() - T_a_room.translation()).norm() > reach_m) continue;
      const double turned_rad = T_a_room.yaw_rad - room.T_map_room.yaw_rad;
      const int turns = quarter_turns(turned_rad);
      if (std::abs(wrap_to_quarter(turned_rad)) < 0.2 && same_size(room, b_.rooms[k], turns))
        return CommonRoom{i, k, turns};
    }
    return std::nullopt;
  }

  /// Half for each door met, minus half for each that only one of the maps has.
  double judge_doors(const Pose2& T_a_b, const CommonRoom& common, double reach_m) const {
    std::vector<Point2> left = doors_a_[common.in_a];
    double score = 0.0;
    for (const Point2& door : doors_b_[common.in_b]) {
      const auto met = std::find_if(left.begin(), left.end(),
                                    [&](const Point2& p) { return (p - T_a_b * door).norm() <= reach_m; });
      score += met == left.end() ? -0.5 : 0.5;
      if (met != left.end()) left.erase(met);
    }
    return score - 0.5 * static_cast<double>(left.size());
  }

  int overlaps(const Rectangle& r) const {
    return static_cast<int>(std::count_if(a_.rooms.begin(), a_.rooms.end(), [&](const Room& room) {
      return depth_of_overlap(room.rectangle(), r) > config_.overlap_m;
    }));
  }

  /// The motion that brings the common rooms together best: mean turn, then mean shift.
  Pose2 fit(const MapAlignment& way) const {
    if (way.common.empty()) return way.T_a_b;
    double turn_rad = 0.0;
    for (const CommonRoom& c : way.common)
      turn_rad += wrap_to_quarter(a_.rooms[c.in_a].T_map_room.yaw_rad - b_.rooms[c.in_b].T_map_room.yaw_rad -
                                  way.T_a_b.yaw_rad);
    const double yaw_rad = wrap_to_pi(way.T_a_b.yaw_rad + turn_rad / static_cast<double>(way.common.size()));
    Point2 shift = Point2::Zero();
    for (const CommonRoom& c : way.common)
      shift += a_.rooms[c.in_a].T_map_room.translation() -
               rotate(yaw_rad, b_.rooms[c.in_b].T_map_room.translation());
    shift /= static_cast<double>(way.common.size());
    return {shift.x(), shift.y(), yaw_rad};
  }

  /// Whether they put b's rooms in different places.
  bool differ(const MapAlignment& one, const MapAlignment& other) const {
    return std::any_of(b_.rooms.begin(), b_.rooms.end(), [&](const Room& room) {
      const Pose2 p = one.T_a_b * room.T_map_room, q = other.T_a_b * room.T_map_room;
      return (p.translation() - q.translation()).norm() > 1.0 ||
             std::abs(wrap_to_pi(p.yaw_rad - q.yaw_rad)) > 0.4;
    });
  }

  const TopologicalMap &a_, &b_;
  const MapMergeConfig& config_;
  DoorPlaces doors_a_, doors_b_;
};

}  // namespace

MapAlignment align_maps(const TopologicalMap& a, const TopologicalMap& b, const MapMergeConfig& config) {
  return MapAligner(a, b, config).align();
}

/// The least motion that would part them (separating axes).
double depth_of_overlap(const Rectangle& a, const Rectangle& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const Rectangle* r : {&a, &b}) {
    for (int i = 0; i < 2; ++i) {
      const Point2 axis = r->normal(i);
      const auto reach = [&axis](const Rectangle& of) {
        double low = 1e300, high = -1e300;
        for (const Point2& p : of.corners())
          low = std::min(low, axis.dot(p)), high = std::max(high, axis.dot(p));
        return std::pair(low, high);
      };
      const auto [low_a, high_a] = reach(a);
      const auto [low_b, high_b] = reach(b);
      least = std::min({least, high_a - low_b, high_b - low_a});
    }
  }
  return least;
}

}  // namespace enfilade::topo_graph
