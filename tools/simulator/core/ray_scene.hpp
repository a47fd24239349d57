// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "tools/simulator/core/world.hpp"

namespace enfilade::simulator {

/// World frame, unit direction.
struct Ray {
  float ox, oy, oz;
  float dx, dy, dz;
};

/// The world as triangles that rays are cast at (Embree). Fixed solids are built once, moving ones may be
/// shifted.
class RayScene {
 public:
  explicit RayScene(const World& world);
  ~RayScene();
  RayScene(RayScene&&) noexcept;
  RayScene& operator=(RayScene&&) noexcept;

  /// Puts moving solid i at `positions[i]`.
  void place_moving(std::span<const Point2> positions);

  /// Distance to the nearest surface along each ray; +inf where there is none or where it is glass.
  void cast(std::span<const Ray> rays, std::span<float> distances_m) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace enfilade::simulator
