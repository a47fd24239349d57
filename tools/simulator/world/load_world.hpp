// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/simulator/core/world.hpp"

namespace enfilade::simulator {

/// Reads a world file: a floor plan (with `rooms`), or a ROS map_server map (with `image`). Throws
/// ConfigError with one line per problem, "file:line: what is wrong, what to do".
World load_world(const std::string& file);

}  // namespace enfilade::simulator
