// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interfaces/runtime/component_log.hpp"
#include "tools/launch/settings.hpp"
#include "tools/report/report.hpp"

namespace enfilade {

/// One death in a composed run, as by SIGKILL; a supervisor starts the component again a second later.
struct Kill {
  std::string component;
  double at_s = 0.0;
};

/// From "COMPONENT@SECONDS"; throws ConfigError.
Kill parse_kill(const std::string& text);

struct ComposedRunOptions {
  std::string world;                  ///< file
  std::optional<std::uint64_t> seed;  ///< of the simulator; none = as configured
  Settings settings;
  bool through_wire = false;  ///< every message makes a trip through its IDL type
  double max_sim_time_s = 3600.0;
  std::vector<Kill> kills;
  LogSink log;
};

/// Throws ConfigError if a component would refuse its configuration.
void check_settings(const Settings& settings);

/// Lets the six components and the simulator explore `world` in this process, on a virtual clock, until the
/// explorer is done or the time is up. Repeatable byte for byte but for the wall time. Throws ConfigError or
/// std::runtime_error on bad input.
report::Report run_composed(const ComposedRunOptions& options);

}  // namespace enfilade
