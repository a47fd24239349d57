// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tools/simulator/core/floor_plan.hpp"
#include "tools/simulator/world/yaml_fields.hpp"

namespace enfilade::simulator {

/// Problems are added to `problems`; what was readable comes back. `name` is the default for the world's
/// name.
FloorPlan read_floor_plan(YamlFields& fields, const std::string& name, YamlProblems& problems);

/// The image path is relative to `folder`. Problems go to those of `fields`.
World read_map_server(YamlFields& fields, const std::string& name, const std::string& folder);

}  // namespace enfilade::simulator
