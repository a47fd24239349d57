// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <functional>

#include "interfaces/model/zone_tag.hpp"

namespace enfilade {

/// Where all code of one component runs, one call at a time.
class Executor {
 public:
  using ExceptionHandler = std::function<void(std::exception_ptr)>;

  virtual ~Executor() = default;
  /// Runs `work` soon, after what was posted before. May be called from any thread.
  virtual void post(std::function<void()> work) = 0;
  /// Runs `work` every `period_ns` on the component's clock, the first time one period from now. For the
  /// component's own thread. A late call is made up for at most once.
  virtual void every(StampNs period_ns, std::function<void()> work) = 0;
  /// The same on wall time, for what must go on while simulated time stands still (heartbeats). In a composed
  /// run: never.
  virtual void every_wall(StampNs period_ns, std::function<void()> work) = 0;
  /// Told of what escapes from work; the executor goes on. For the machinery that drives a node, before any
  /// work is given.
  virtual void on_exception(ExceptionHandler) {}
};

}  // namespace enfilade
