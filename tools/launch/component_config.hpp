// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "interfaces/runtime/command_line.hpp"
#include "tools/launch/settings.hpp"

namespace enfilade {

/// A component's configuration: the file it ships with, and what the command line sets. Throws ConfigError
/// that names keys as COMPONENT.KEY.
template <class Config>
Config load_component_config(const std::string& component, const Settings& settings) {
  return load_config<Config>(find_config_file(component, executable_path(), process_environment),
                             settings.of(component), nullptr, component + ".");
}

}  // namespace enfilade
