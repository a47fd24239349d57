// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "interfaces/runtime/config.hpp"

namespace enfilade {

/// What a component is told on its command line.
struct CommandLine {
  std::string config_file;  ///< empty: find_config_file()
  ConfigOverrides overrides;
  std::optional<int> domain;
  bool sim_time = false;
  std::string log_level = "info";
};

/// The exit status when there is nothing to run: 0 after --help, 2 after a mistake (with a sentence on
/// stderr).
struct ParsedCommandLine {
  std::optional<CommandLine> command_line;
  int exit_status = 0;
};

ParsedCommandLine parse_command_line(const std::string& component, int argc, const char* const* argv);

/// Reads one environment variable; nothing if it is not set or empty.
using Environment = std::function<std::optional<std::string>(const char* name)>;
std::optional<std::string> process_environment(const char* name);

/// --domain, else ENFILADE_DOMAIN, else ROS_DOMAIN_ID, else 0. Throws ConfigError if the one that counts is
/// not 0 to 232.
int resolve_domain(std::optional<int> from_command_line, const Environment& environment);

/// COMPONENT.yaml in $ENFILADE_ETC, else in the etc/ of the checkout or of the install that the executable
/// belongs to. Throws ConfigError naming where it looked.
std::string find_config_file(const std::string& component, const std::string& executable,
                             const Environment& environment);

/// The file of the running program.
std::string executable_path();

}  // namespace enfilade
