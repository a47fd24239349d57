// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "interfaces/bus/bus.hpp"
#include "interfaces/runtime/clock.hpp"
#include "interfaces/runtime/executor.hpp"
#include "interfaces/runtime/log.hpp"

namespace enfilade {

/// A component's way to change its own life cycle state.
class Lifecycle {
 public:
  virtual ~Lifecycle() = default;
  /// From now on `emergency()` is called in place of `compute()`. `reason` is one sentence for people.
  virtual void go_to_emergency(std::string reason) = 0;
  /// Leaves the emergency: `restore()` once, then `compute()` again.
  virtual void go_to_restore() = 0;
  virtual bool in_emergency() const = 0;
};

/// What a node is given; outlives it.
struct NodeContext {
  std::string component;  ///< "gridBuilder"
  Bus& bus;
  const Clock& clock;
  Executor& executor;
  Log& log;
  Lifecycle& lifecycle;
};

/// The thin shell round a component's core: it moves values between the bus and the core. Written once, it
/// runs deployed (a process on DDS) and composed (on the in-process bus). All calls come from one executor
/// thread.
class Node {
 public:
  virtual ~Node() = default;
  /// Once, before anything else: open topics. May throw ConfigError or std::runtime_error, which ends the
  /// process.
  virtual void initialize() = 0;
  /// Every `period.compute_s` of the component's configuration.
  virtual void compute() = 0;
  /// Every `period.emergency_s` while in emergency.
  virtual void emergency() {}
  /// Once, when the emergency ends.
  virtual void restore() {}
  /// Once, when the component stops in good order.
  virtual void shutdown() {}
};

}  // namespace enfilade
