// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "interfaces/model/zone_tag.hpp"

namespace enfilade::motor_control {

/// A number that differs between two starts of the component, never 0: a hash of what tells the process apart
/// from others and of when it started. In a composed run (`run_id` empty), which must repeat itself byte for
/// byte, it counts the tenths of a virtual second, within which nobody starts twice.
std::uint32_t odom_boot_of(const std::string& run_id, StampNs started_ns);

}  // namespace enfilade::motor_control
