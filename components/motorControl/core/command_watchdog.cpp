// SPDX-License-Identifier: Apache-2.0
#include "components/motorControl/core/command_watchdog.hpp"

#include <stdexcept>

namespace enfilade::motor_control {

CommandWatchdog::CommandWatchdog(const CommandWatchdogConfig& config) : config_(config) {
  if (!(config.stale_after_s > 0.0))
    throw std::invalid_argument("watchdog: stale_after_s must be greater than 0");
}

void CommandWatchdog::take(const VelocityCommand& command, StampNs now_ns) {
  command_ = command;
  taken_ns_ = now_ns;
}

std::optional<VelocityCommand> CommandWatchdog::command(StampNs now_ns) const {
  // A clock that ran backwards (a new simulation) makes the command as worthless as its age would.
  if (now_ns < taken_ns_ || seconds(now_ns - taken_ns_) > config_.stale_after_s) return std::nullopt;
  return command_;
}

}  // namespace enfilade::motor_control
