// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/node/odom_boot.hpp"

namespace enfilade::motor_control {

std::uint32_t odom_boot_of(const std::string& run_id, StampNs started_ns) {
  if (run_id.empty()) return static_cast<std::uint32_t>(1 + started_ns / from_seconds(0.1));
  std::uint32_t hash = 2166136261u;  // FNV-1a
  for (const char c : run_id + "@" + std::to_string(started_ns))
    hash = (hash ^ static_cast<std::uint8_t>(c)) * 16777619u;
  return hash == 0 ? 1 : hash;
}

}  // namespace enfilade::motor_control
