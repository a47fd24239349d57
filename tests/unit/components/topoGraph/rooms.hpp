// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "components/topoGraph/core/topo_graph.hpp"

/// A small world with known answers: two rooms side by side, a wall of 0.15 m between them, a door in it.
namespace enfilade::topo_graph::test {

inline constexpr double kThicknessM = 0.15;

inline Rectangle room1() { return {0.0, 0.0, 0.0, 3.2, 3.8}; }
/// Right of room 1.
inline Rectangle room2() { return {0.0, 1.6 + kThicknessM + 2.1, 0.0, 4.2, 3.8}; }

inline DoorEstimate open_door(int wall, double from_m, double to_m) {
  return {.gap = {static_cast<std::uint8_t>(wall), from_m, to_m}, .state = DoorState::kOpen};
}

/// The door between the rooms at y in [0.1, 1.0] as room 1 and as room 2 sees it.
inline DoorEstimate door_from_room1() { return open_door(0, 2.0, 2.9); }
inline DoorEstimate door_from_room2() { return open_door(2, 0.9, 1.8); }
/// A second door between them, y in [-1.5, -0.7].
inline DoorEstimate second_from_room1() { return open_door(0, 0.4, 1.2); }
inline DoorEstimate second_from_room2() { return open_door(2, 2.6, 3.4); }

inline RoomEstimate estimate_of(const Rectangle& rectangle, std::uint32_t zone_id,
                                std::vector<DoorEstimate> doors) {
  RoomEstimate estimate;
  estimate.tag = {.zone_id = zone_id, .grid_epoch = zone_id, .odom_boot = 1};
  estimate.stamp_ns = from_seconds(10.0 * zone_id);
  estimate.found = true;
  estimate.rectangle = rectangle;
  estimate.doors = std::move(doors);
  return estimate;
}

/// The same thing seen from a frame that odometry has moved: T_zone_true takes true coordinates into the zone
/// frame.
inline RoomEstimate seen_from(const Pose2& T_zone_true, RoomEstimate estimate) {
  estimate.rectangle = T_zone_true * estimate.rectangle;
  if (estimate.recent) estimate.recent = T_zone_true * *estimate.recent;
  return estimate;
}

inline CallId call(std::uint64_t number) { return {"explorer", number}; }

inline TopoGraph new_graph(const GraphConfig& config = {}) { return {config, first_state(0)}; }

inline Pose2 random_pose(std::mt19937& random, double reach_m, double reach_rad) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  return {reach_m * unit(random), reach_m * unit(random), reach_rad * unit(random)};
}

inline void expect_near(const Pose2& a, const Pose2& b, double tolerance) {
  EXPECT_NEAR(a.x_m, b.x_m, tolerance);
  EXPECT_NEAR(a.y_m, b.y_m, tolerance);
  EXPECT_NEAR(wrap_to_pi(a.yaw_rad - b.yaw_rad), 0.0, tolerance);
}

/// Room 1 fixed in zone 1, then zone 2 entered through its door 1, the robot 0.5 m behind the wall.
inline TopoGraph graph_in_zone2(const GraphConfig& config = {},
                                std::vector<DoorEstimate> doors = {door_from_room1()}) {
  TopoGraph graph = new_graph(config);
  graph.fix_room({call(1), estimate_of(room1(), 1, std::move(doors))}, from_seconds(11.0));
  graph.enter_zone({call(2), 1, 1, {2.25, 0.55, 0.0}, from_seconds(15.0)}, from_seconds(16.0));
  return graph;
}

/// … and room 2 fixed as seen through an odometry that is wrong by `T_zone_true`.
inline FixRoomOutcome fix_room2(TopoGraph& graph, const Pose2& T_zone_true,
                                std::vector<DoorEstimate> doors = {door_from_room2()}) {
  return graph.fix_room({call(3), seen_from(T_zone_true, estimate_of(room2(), 2, std::move(doors)))},
                        from_seconds(25.0));
}

}  // namespace enfilade::topo_graph::test
