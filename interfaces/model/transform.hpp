// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interfaces/geometry/pose2.hpp"
#include "interfaces/model/zone_tag.hpp"

namespace enfilade {

/// A rigid motion in space as it travels: translation in metres and a unit quaternion. Kept apart from Pose2
/// so that a message survives the wire bit for bit.
struct Transform3 {
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
  double qx = 0.0, qy = 0.0, qz = 0.0, qw = 1.0;

  bool operator==(const Transform3&) const = default;
};

Transform3 to_transform3(const Pose2& pose);
/// The planar part: x, y and the rotation about z.
Pose2 to_pose2(const Transform3& transform);

struct StampedTransform {
  StampNs stamp_ns = 0;
  std::string frame_id;        ///< parent a of T_a_b
  std::string child_frame_id;  ///< child b
  Transform3 transform;

  bool operator==(const StampedTransform&) const = default;
};

/// rt/tf and rt/tf_static.
struct TransformList {
  std::vector<StampedTransform> transforms;

  bool operator==(const TransformList&) const = default;
};

/// T_parent_child, if the list holds it.
std::optional<Pose2> find_transform(const TransformList& list, std::string_view parent,
                                    std::string_view child);

/// T_zone_odom, if gridBuilder tells it in this list: odometry drifts in the frame of the zone, so `zone`
/// hangs below `odom` on tf.
std::optional<Pose2> find_zone_odom(const TransformList& list);

}  // namespace enfilade
