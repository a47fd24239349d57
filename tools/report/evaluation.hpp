// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "interfaces/model/topological_map.hpp"
#include "tools/simulator/core/world_truth.hpp"

namespace enfilade::report {

/// A room of the map against the world, world frame, yaw in [-π/4, π/4).
struct RoomReport {
  RoomId id = 0;
  Rectangle measured;
  std::vector<DoorId> doors;
  std::optional<std::size_t> truth_index;  ///< into WorldTruth::rooms
  std::optional<Rectangle> truth;          ///< with the sides named as in `measured`
  double iou = 0.0;                        ///< with `truth`; 0 without
};

struct DoorReport {
  DoorId id = 0;
  DoorKind kind = DoorKind::kUnresolved;
  std::vector<RoomId> rooms;  ///< one or two
  Segment opening;            ///< between the faces where both are known
  std::optional<std::size_t> truth_index;
  std::optional<Segment> truth;

  /// How far the middle of the opening is off along the wall; across it, an exit is known by its inner face
  /// only. With truth.
  double shift_m() const;
};

/// Rates are fractions; what is not defined (no truth, nothing found) is empty.
struct Metrics {
  std::optional<double> room_precision, room_recall, room_iou_mean;
  std::optional<double> size_error_mean_m, size_error_max_m, center_error_mean_m;
  std::optional<double> door_precision, door_recall, door_error_mean_m;
  std::optional<int> rooms_true, doors_true;
  int rooms_found = 0, doors_found = 0;
};

struct Evaluation {
  std::vector<RoomReport> rooms;
  std::vector<DoorReport> doors;
  Metrics metrics;
};

/// Lays the map over the world through the robot's true start pose. A room matches the true room it overlaps
/// most, at IoU ≥ 0.5; a door matches a true one in the same wall (parallel within 20°, at most 0.35 m
/// across) at interval IoU > 0.4; each true one is matched at most once.
Evaluation evaluate(const TopologicalMap& map, const simulator::WorldTruth& truth);

}  // namespace enfilade::report
