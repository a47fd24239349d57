// SPDX-License-Identifier: Apache-2.0
#include "interfaces/model/transform.hpp"

#include <cmath>

namespace enfilade {

Transform3 to_transform3(const Pose2& pose) {
  return {.x_m = pose.x_m,
          .y_m = pose.y_m,
          .qz = std::sin(0.5 * pose.yaw_rad),
          .qw = std::cos(0.5 * pose.yaw_rad)};
}

Pose2 to_pose2(const Transform3& t) {
  const double yaw = std::atan2(2.0 * (t.qw * t.qz + t.qx * t.qy), 1.0 - 2.0 * (t.qy * t.qy + t.qz * t.qz));
  return {t.x_m, t.y_m, yaw};
}

std::optional<Pose2> find_transform(const TransformList& list, std::string_view parent,
                                    std::string_view child) {
  for (const StampedTransform& t : list.transforms) {
    if (t.frame_id == parent && t.child_frame_id == child) return to_pose2(t.transform);
  }
  return std::nullopt;
}

std::optional<Pose2> find_zone_odom(const TransformList& list) {
  const auto T_odom_zone = find_transform(list, "odom", "zone");
  return T_odom_zone ? std::optional(T_odom_zone->inverse()) : std::nullopt;
}

}  // namespace enfilade
