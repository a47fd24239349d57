// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "interfaces/model/topological_map.hpp"

namespace enfilade {

/// The steps of section IV, as the explorer names them.
enum class ExplorationPhase : std::uint8_t {
  kWaiting = 0,      ///< for a zone, a grid, a pose
  kScanning = 1,     ///< a sweep is under way
  kLooking = 2,      ///< driving or turning towards what is unexplored
  kVerifying = 3,    ///< the finer sweep that must change nothing
  kFixing = 4,       ///< FixRoom is under way
  kApproaching = 5,  ///< driving to a door
  kCrossing = 6,     ///< going through it
  kEntering = 7,     ///< EnterZone is under way
  kFinished = 8,     ///< no door is left
  kStuck = 9,        ///< cannot go on; `activity` says why
};

struct ExplorationState {
  ZoneTag tag;
  StampNs stamp_ns = 0;
  ExplorationPhase phase = ExplorationPhase::kWaiting;
  std::string activity;  ///< one line for people
  std::uint32_t sweeps_in_zone = 0;
  std::uint32_t sweeps_total = 0;
  double unexplored_wall_share = 1.0;
  std::optional<RoomId> room;  ///< the room the robot is in, where it is in the graph
  std::optional<DoorId> target_door;
  std::optional<Pose2> goal;  ///< zone frame

  bool operator==(const ExplorationState&) const = default;
};

}  // namespace enfilade
