// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace enfilade {

/// The part of DDS QoS that differs between topics of ours. History is always KEEP_LAST.
struct Qos {
  bool reliable = true;
  bool latched = false;  ///< TRANSIENT_LOCAL: a late reader gets the last `depth` samples
  int depth = 10;
};

/// One row of the topic table. Writers and readers are names of components, separated by one space; "*" is
/// every component. Tools (participants whose name starts with "enfilade") may read everything and write
/// nothing but what lists "enfilade".
struct TopicInfo {
  std::string_view name;       ///< DDS topic name; "rt/x" is the ROS 2 topic /x
  std::string_view wire_type;  ///< DDS type name
  Qos qos;
  double rate_hz = 0.0;  ///< nominal; 0 = on events
  std::string_view writers;
  std::string_view readers;
};

/// Ties a row of the table to the model type that travels on it.
template <class T>
struct Topic {
  using Message = T;
  TopicInfo info;
};

/// A request topic and its reply topic. Both messages hold a `CallId call`.
template <class Q, class A>
struct Service {
  Topic<Q> request;
  Topic<A> reply;
};

/// Whether `name` is one of the space-separated `names`, or a component and these are "*".
bool lists(std::string_view names, std::string_view name);
bool is_tool(std::string_view participant);
bool may_write(const TopicInfo& topic, std::string_view participant);
bool may_read(const TopicInfo& topic, std::string_view participant);

}  // namespace enfilade
