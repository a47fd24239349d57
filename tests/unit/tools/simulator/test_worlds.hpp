// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tools/simulator/core/floor_plan.hpp"
#include "tools/simulator/core/shapes.hpp"
#include "tools/simulator/core/simulation.hpp"

namespace enfilade::simulator::test {

inline constexpr double kWall_m = 0.12;
inline constexpr double kCeiling_m = 2.6;

/// One closed room about the building's origin.
inline FloorPlan one_room(double width_m, double height_m) {
  FloorPlan plan;
  plan.name = "one room";
  plan.wall_thickness_m = kWall_m;
  plan.rooms.push_back({"a", Rectangle{.width_m = width_m, .height_m = height_m}, kCeiling_m, 1});
  return plan;
}

/// Room a (4 × 3) at the origin and b (2 × 3) east of it, one wall thickness apart.
inline FloorPlan two_rooms() {
  FloorPlan plan = one_room(4.0, 3.0);
  plan.rooms.push_back(
      {"b", Rectangle{.x_m = 3.0 + kWall_m, .width_m = 2.0, .height_m = 3.0}, kCeiling_m, 2});
  return plan;
}

/// A door in the east wall of a; its middle lies 0.5 m south of the wall's middle.
inline PlanDoor east_door(std::optional<std::size_t> to) {
  return {{.room = 0, .wall = 0, .middle_m = 1.0, .width_m = 0.9, .bottom_m = 0.0, .top_m = 2.0, .line = 3},
          to};
}

inline SimulationConfig without_noise() {
  SimulationConfig config;
  config.laser.sigma_near_m = config.laser.sigma_far_m = 0.0;
  config.laser.dropout_probability = config.laser.mixed_pixel_probability = 0.0;
  config.drive.left_radius_scale = config.drive.right_radius_scale = config.drive.track_scale = 1.0;
  config.drive.slip_m_per_sqrt_m = 0.0;
  config.drive.encoder_ticks_per_turn = 0;
  config.roll.steps_per_turn = 0;
  config.command_timeout_s = 0.0;
  return config;
}

/// Distance from `from` along the unit direction to the nearest surface.
inline float range_along(const RayScene& scene, const Eigen::Vector3f& from,
                         const Eigen::Vector3f& direction) {
  const Ray ray{from.x(), from.y(), from.z(), direction.x(), direction.y(), direction.z()};
  float range_m = 0.0f;
  scene.cast({&ray, 1}, {&range_m, 1});
  return range_m;
}

}  // namespace enfilade::simulator::test
