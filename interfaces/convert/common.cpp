// SPDX-License-Identifier: Apache-2.0
#include "interfaces/convert/common.hpp"

#include <limits>

namespace enfilade::wire {

namespace {

constexpr StampNs kSecond = 1'000'000'000;

}  // namespace

void check_count(std::size_t count, std::size_t most, const char* what) {
  if (count <= most) return;
  throw WireError(std::to_string(count) + " " + what + ", where at most " + std::to_string(most) +
                  " are believed");
}

const std::string& checked(const std::string& text) {
  check_count(text.size(), kMaxTextBytes, "bytes of text");
  return text;
}

ros_time::Time_ to_wire(StampNs stamp_ns) {
  const StampNs nanosec = ((stamp_ns % kSecond) + kSecond) % kSecond;
  const StampNs sec = stamp_ns / kSecond - (stamp_ns % kSecond < 0 ? 1 : 0);
  if (sec > std::numeric_limits<std::int32_t>::max() || sec < std::numeric_limits<std::int32_t>::min()) {
    throw WireError("the stamp " + std::to_string(stamp_ns) + " ns does not fit the 32-bit seconds of ROS 2");
  }
  ros_time::Time_ time;
  time.sec(static_cast<std::int32_t>(sec));
  time.nanosec(static_cast<std::uint32_t>(nanosec));
  return time;
}

StampNs from_wire(const ros_time::Time_& time) {
  if (time.nanosec() >= kSecond)
    throw WireError("a stamp has " + std::to_string(time.nanosec()) + " ns in its second");
  return time.sec() * kSecond + time.nanosec();
}

ros_std::Header_ header_to_wire(StampNs stamp_ns, const std::string& frame_id) {
  ros_std::Header_ header;
  header.stamp(to_wire(stamp_ns));
  header.frame_id(frame_id);
  return header;
}

own::ZoneTag_ to_wire(const ZoneTag& tag) {
  own::ZoneTag_ out;
  out.zone_id(tag.zone_id);
  out.grid_epoch(tag.grid_epoch);
  out.odom_boot(tag.odom_boot);
  return out;
}

ZoneTag from_wire(const own::ZoneTag_& tag) { return {tag.zone_id(), tag.grid_epoch(), tag.odom_boot()}; }

own::Pose2_ to_wire(const Pose2& pose) {
  own::Pose2_ out;
  out.x_m(pose.x_m);
  out.y_m(pose.y_m);
  out.yaw_rad(pose.yaw_rad);
  return out;
}

Pose2 from_wire(const own::Pose2_& pose) { return {pose.x_m(), pose.y_m(), pose.yaw_rad()}; }

own::Rectangle_ to_wire(const Rectangle& rectangle) {
  own::Rectangle_ out;
  out.yaw_rad(rectangle.yaw_rad);
  out.x_m(rectangle.x_m);
  out.y_m(rectangle.y_m);
  out.width_m(rectangle.width_m);
  out.height_m(rectangle.height_m);
  return out;
}

Rectangle from_wire(const own::Rectangle_& rectangle) {
  return {rectangle.yaw_rad(), rectangle.x_m(), rectangle.y_m(), rectangle.width_m(), rectangle.height_m()};
}

own::CallId_ to_wire(const CallId& call) {
  own::CallId_ out;
  out.client(call.client);
  out.number(call.number);
  return out;
}

CallId from_wire(const own::CallId_& call) { return {checked(call.client()), call.number()}; }

std::vector<own::Point2_> outline_to_wire(const std::vector<Point2>& outline) {
  return each<own::Point2_>(outline, [](const Point2& point) {
    own::Point2_ out;
    out.x_m(point.x());
    out.y_m(point.y());
    return out;
  });
}

std::vector<Point2> outline_from_wire(const std::vector<own::Point2_>& outline) {
  check_count(outline.size(), kMaxOutlinePoints, "outline points");
  return each<Point2>(outline, [](const own::Point2_& point) { return Point2(point.x_m(), point.y_m()); });
}

}  // namespace enfilade::wire
