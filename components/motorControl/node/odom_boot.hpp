// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "interfaces/model/zone_tag.hpp"

namespace enfilade::motor_control {

/// A number that differs between two starts of the component, never 0: a hash of what tells the process apart
/// from others and of when it started. In a composed run (`run_id` empty) it is 1 and a tenth of a second
/// later the next, so that every run is the same byte for byte.
std::uint32_t odom_boot_of(const std::string& run_id, StampNs started_ns);

}  // namespace enfilade::motor_control
