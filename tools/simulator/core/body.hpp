// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "interfaces/geometry/pose2.hpp"
#include "tools/simulator/core/world.hpp"

namespace enfilade::simulator {

/// The robot's body: an upright cylinder about base_link.
struct BodyConfig {
  double radius_m = 0.22;  ///< > 0
  double height_m = 0.40;  ///< what the laser sees of it, > 0
  double contact_height_m =
      0.70;  ///< what stands or hangs lower than this can be touched (the laser's mast), > 0
};

/// Keeps the robot out of walls, furniture and whoever walks by, and counts how often it ran into them.
class Body {
 public:
  Body(const BodyConfig& config, const World& world);

  /// The pose really reached: a step that would go deeper into something only turns. A contact is counted
  /// when it begins.
  Pose2 move(const Pose2& from, const Pose2& to, const std::vector<std::vector<Point2>>& moving);

  /// Whether the robot could stand there without touching what never moves.
  bool fits(const Point2& position) const { return clearance_m(position, {}) > 0.0; }
  std::uint32_t collisions() const { return collisions_; }

 private:
  /// From the body's hull to the nearest obstacle; negative inside one. Large distances are cut short.
  double clearance_m(const Point2& position, const std::vector<std::vector<Point2>>& moving) const;

  BodyConfig config_;
  std::vector<std::vector<Point2>> fixed_;
  bool touching_ = false;
  std::uint32_t collisions_ = 0;
};

}  // namespace enfilade::simulator
