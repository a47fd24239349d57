// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <enfilade_idl/builtin_interfaces.h>
#include <enfilade_idl/enfilade_common.h>
#include <enfilade_idl/std_msgs.h>

#include "interfaces/convert/wire_error.hpp"
#include "interfaces/geometry/rectangle.hpp"
#include "interfaces/model/requests.hpp"

/// to_wire makes the IDL type of a model value; from_wire makes the value again, equal bit for bit, or throws
/// WireError.
namespace enfilade::wire {

namespace ros_time = ::builtin_interfaces::msg::dds_;
namespace ros_std = ::std_msgs::msg::dds_;
namespace own = ::enfilade_msgs::msg::dds_;

/// Seconds must fit 32 bits (until 2038), as ROS 2 has it.
ros_time::Time_ to_wire(StampNs stamp_ns);
StampNs from_wire(const ros_time::Time_& time);

ros_std::Header_ header_to_wire(StampNs stamp_ns, const std::string& frame_id);

own::ZoneTag_ to_wire(const ZoneTag& tag);
ZoneTag from_wire(const own::ZoneTag_& tag);
own::Pose2_ to_wire(const Pose2& pose);
Pose2 from_wire(const own::Pose2_& pose);
own::Rectangle_ to_wire(const Rectangle& rectangle);
Rectangle from_wire(const own::Rectangle_& rectangle);
own::CallId_ to_wire(const CallId& call);
CallId from_wire(const own::CallId_& call);
std::vector<own::Point2_> outline_to_wire(const std::vector<Point2>& outline);
std::vector<Point2> outline_from_wire(const std::vector<own::Point2_>& outline);

/// A text of believable length.
const std::string& checked(const std::string& text);

template <class E>
std::uint8_t enum_to_wire(E value) {
  return static_cast<std::uint8_t>(value);
}

/// Throws WireError unless `value` is one of the enumerators 0 … `last`.
template <class E>
E enum_from_wire(std::uint8_t value, E last, const char* what) {
  if (value > static_cast<std::uint8_t>(last)) {
    throw WireError(std::string(what) + " is " + std::to_string(value) + ", which means nothing");
  }
  return static_cast<E>(value);
}

template <class T>
std::optional<T> optional_from_wire(bool has, const T& value) {
  return has ? std::optional<T>(value) : std::nullopt;
}

/// Every element of a sequence through to_wire or from_wire.
template <class To, class From, class Convert>
std::vector<To> each(const std::vector<From>& from, Convert convert) {
  std::vector<To> to;
  to.reserve(from.size());
  for (const From& element : from) to.push_back(convert(element));
  return to;
}

}  // namespace enfilade::wire
