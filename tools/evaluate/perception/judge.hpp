// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tools/evaluate/perception/trial.hpp"
#include "tools/simulator/core/ray_scene.hpp"

namespace enfilade::evaluate {

/// A true door as a gap in the true room, and the share of it that the laser could see.
struct VisibleDoor {
  WallInterval gap;
  double visible_share = 0.0;
};

inline constexpr double kLeastVisibleShare = 0.6;

/// The opening, which lies within a wall, as a gap of the nearest wall of the room.
WallInterval gap_of(const Segment& opening, const Rectangle& room);

/// Share of the plane of an opening, 0.15 m over the floor up to below its lintel, that some stand of the
/// robot has in sight.
double visible_share(const Segment& opening, double height_m, std::span<const Pose2> T_world_base,
                     const simulator::RayScene& scene);

std::vector<double> size_errors_m(const Rectangle& found, const Rectangle& truth);
/// Nothing where the estimate has no covariance.
std::optional<double> nees(const RoomEstimate& estimate, const Rectangle& truth);
DoorTally judge_doors(const RoomEstimate& estimate, const Rectangle& truth,
                      const std::vector<VisibleDoor>& doors);

}  // namespace enfilade::evaluate
