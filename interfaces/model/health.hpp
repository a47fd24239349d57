// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "interfaces/model/zone_tag.hpp"

namespace enfilade {

enum class LifecycleState : std::uint8_t {
  kInitializing = 0,
  kComputing = 1,
  kEmergency = 2,
  kRestoring = 3,
  kStopping = 4
};

/// From the component's own executor thread, so that a hung loop is seen and not only a dead process.
struct Heartbeat {
  std::string component_name;
  std::string host;
  std::uint32_t pid = 0;
  StampNs wall_ns = 0;
  LifecycleState state = LifecycleState::kInitializing;
  std::uint64_t cycles = 0;  ///< calls of compute() so far
  std::string detail;        ///< why, in emergency

  bool operator==(const Heartbeat&) const = default;
};

/// rt/rosout: a line for people. Levels as in ROS 2: 10 debug, 20 info, 30 warn, 40 error.
struct LogLine {
  StampNs stamp_ns = 0;
  std::uint8_t level = 20;
  std::string component_name;
  std::string text;

  bool operator==(const LogLine&) const = default;
};

}  // namespace enfilade
