// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "interfaces/model/motion.hpp"

namespace enfilade::motor_control {

struct CommandWatchdogConfig {
  double stale_after_s = 0.2;  ///< an older velocity command no longer counts, > 0
};

/// Keeps the newest velocity command, and forgets it when it grows old. Stamps are of the node's clock.
class CommandWatchdog {
 public:
  explicit CommandWatchdog(const CommandWatchdogConfig& config);

  void take(const VelocityCommand& command, StampNs now_ns);
  /// The command to follow; nothing where none came or the last one is stale.
  std::optional<VelocityCommand> command(StampNs now_ns) const;
  void forget() { command_.reset(); }

 private:
  CommandWatchdogConfig config_;
  std::optional<VelocityCommand> command_;
  StampNs taken_ns_ = 0;
};

}  // namespace enfilade::motor_control
