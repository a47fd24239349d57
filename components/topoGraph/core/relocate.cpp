// SPDX-License-Identifier: Apache-2.0
#include "components/topoGraph/core/relocate.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "components/topoGraph/core/pose_tracker.hpp"

namespace enfilade::topo_graph {
namespace {

constexpr double kSamePlaceM = 0.3;

/// How many of the estimate's open gaps lie on a door of the room.
int doors_met(const TopologicalMap& map, const Room& room, const RoomEstimate& estimate,
              const Pose2& T_map_zone) {
  const auto is_door = [&](const Point2& middle) {
    return std::any_of(map.doors.begin(), map.doors.end(), [&](const Door& door) {
      const DoorFace* face = TopologicalMap::find_face(door, room.id);
      return face && (segment_in_map(room, *face).midpoint() - middle).norm() < kSamePlaceM;
    });
  };
  return static_cast<int>(
      std::count_if(estimate.doors.begin(), estimate.doors.end(), [&](const DoorEstimate& door) {
        return door.state == DoorState::kOpen &&
               is_door(T_map_zone * segment_of(estimate.rectangle, door.gap).midpoint());
      }));
}

}  // namespace

std::optional<Pose2> relocate(const TopologicalMap& map, const Room& room, const RoomEstimate& estimate,
                              const Pose2& T_map_zone_before, double max_size_difference_m) {
  const auto turned = [&](const Pose2& pose) {
    return std::abs(wrap_to_pi(pose.yaw_rad - T_map_zone_before.yaw_rad));
  };
  std::optional<Pose2> best;
  int best_met = 0;
  for (const Pose2& T_zone_room : namings(room.rectangle(), estimate.rectangle, max_size_difference_m)) {
    const Pose2 T_map_zone = room.T_map_room * T_zone_room.inverse();
    const int met = doors_met(map, room, estimate, T_map_zone);
    if (best && (met < best_met || (met == best_met && turned(T_map_zone) >= turned(*best)))) continue;
    best = T_map_zone;
    best_met = met;
  }
  return best;
}

}  // namespace enfilade::topo_graph
