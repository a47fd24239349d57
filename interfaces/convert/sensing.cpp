// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/sensing.hpp"

namespace enfilade::wire {

namespace {

ros_geometry::Quaternion_ rotation_to_wire(const Transform3& transform) {
  ros_geometry::Quaternion_ out;
  out.x(transform.qx);
  out.y(transform.qy);
  out.z(transform.qz);
  out.w(transform.qw);
  return out;
}

/// Vector3 and Point have the same members.
template <class V>
V translation_to_wire(const Transform3& transform) {
  V out;
  out.x(transform.x_m);
  out.y(transform.y_m);
  out.z(transform.z_m);
  return out;
}

template <class V>
Transform3 transform_from_wire(const V& t, const ros_geometry::Quaternion_& q) {
  return {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()};
}

ros_geometry::TransformStamped_ stamped_to_wire(const StampedTransform& stamped) {
  ros_geometry::TransformStamped_ out;
  out.header(header_to_wire(stamped.stamp_ns, stamped.frame_id));
  out.child_frame_id(stamped.child_frame_id);
  out.transform().translation(translation_to_wire<ros_geometry::Vector3_>(stamped.transform));
  out.transform().rotation(rotation_to_wire(stamped.transform));
  return out;
}

StampedTransform stamped_from_wire(const ros_geometry::TransformStamped_& stamped) {
  return {from_wire(stamped.header().stamp()), checked(stamped.header().frame_id()),
          checked(stamped.child_frame_id()),
          transform_from_wire(stamped.transform().translation(), stamped.transform().rotation())};
}

}  // namespace

ros_sensor::LaserScan_ to_wire(const LaserScan& scan) {
  ros_sensor::LaserScan_ out;
  out.header(header_to_wire(scan.stamp_ns, scan.frame_id));
  out.angle_min(scan.angle_min_rad);
  out.angle_max(scan.angle_max_rad);
  out.angle_increment(scan.angle_increment_rad);
  out.time_increment(scan.time_increment_s);
  out.scan_time(scan.scan_time_s);
  out.range_min(scan.range_min_m);
  out.range_max(scan.range_max_m);
  out.ranges(scan.ranges_m);
  out.intensities(scan.intensities);
  return out;
}

LaserScan from_wire(const ros_sensor::LaserScan_& scan) {
  check_count(scan.ranges().size(), kMaxBeams, "ranges");
  check_count(scan.intensities().size(), kMaxBeams, "intensities");
  return {.stamp_ns = from_wire(scan.header().stamp()),
          .frame_id = checked(scan.header().frame_id()),
          .angle_min_rad = scan.angle_min(),
          .angle_max_rad = scan.angle_max(),
          .angle_increment_rad = scan.angle_increment(),
          .time_increment_s = scan.time_increment(),
          .scan_time_s = scan.scan_time(),
          .range_min_m = scan.range_min(),
          .range_max_m = scan.range_max(),
          .ranges_m = scan.ranges(),
          .intensities = scan.intensities()};
}

ros_sensor::JointState_ to_wire(const JointStates& joints) {
  ros_sensor::JointState_ out;
  out.header(header_to_wire(joints.stamp_ns, ""));
  out.name(joints.names);
  out.position(joints.positions_rad);
  out.velocity(joints.velocities_rad_s);
  return out;
}

JointStates from_wire(const ros_sensor::JointState_& joints) {
  const std::size_t count = joints.name().size();
  check_count(count, kMaxJoints, "joints");
  const std::size_t velocities = joints.velocity().size();
  if (joints.position().size() != count || (velocities != 0 && velocities != count)) {
    throw WireError(std::to_string(count) + " joints have " + std::to_string(joints.position().size()) +
                    " positions and " + std::to_string(velocities) + " velocities");
  }
  JointStates out{from_wire(joints.header().stamp()), joints.name(), joints.position(), joints.velocity()};
  out.velocities_rad_s.resize(count, 0.0);
  return out;
}

ros_nav::Odometry_ to_wire(const Odometry& odometry) {
  ros_nav::Odometry_ out;
  out.header(header_to_wire(odometry.stamp_ns, "odom"));
  out.child_frame_id("base_link");
  out.pose().pose().position(translation_to_wire<ros_geometry::Point_>(odometry.T_odom_base));
  out.pose().pose().orientation(rotation_to_wire(odometry.T_odom_base));
  out.twist().twist().linear().x(odometry.linear_m_s);
  out.twist().twist().angular().z(odometry.angular_rad_s);
  return out;
}

Odometry from_wire(const ros_nav::Odometry_& odometry) {
  const auto& pose = odometry.pose().pose();
  const auto& twist = odometry.twist().twist();
  return {from_wire(odometry.header().stamp()), transform_from_wire(pose.position(), pose.orientation()),
          twist.linear().x(), twist.angular().z()};
}

ros_tf2::TFMessage_ to_wire(const TransformList& list) {
  ros_tf2::TFMessage_ out;
  out.transforms(each<ros_geometry::TransformStamped_>(list.transforms, stamped_to_wire));
  return out;
}

TransformList from_wire(const ros_tf2::TFMessage_& list) {
  check_count(list.transforms().size(), kMaxTransforms, "transforms");
  return {each<StampedTransform>(list.transforms(), stamped_from_wire)};
}

}  // namespace enfilade::wire
