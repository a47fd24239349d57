// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "interfaces/bus/bus.hpp"
#include "interfaces/model/simulation.hpp"
#include "interfaces/runtime/deployed_clock.hpp"
#include "interfaces/runtime/thread_executor.hpp"

namespace enfilade {

struct SimulatedTimeConfig {
  std::string component;
  double credit_period_s = 0.02;  ///< simulated time between two credits at least; > 0
};

/// Lets a component live in the time of rt/clock, and tells the simulator by rt/sim/credit when all that
/// arrived up to a tick has been handled, so that it can wait for its slowest reader.
///
/// A tick arrives through the same queue as everything else: once it is handled, so is all that came before
/// it. The credit goes to the end of the queue once more, and so also vouches for what came in the meantime.
class SimulatedTime {
 public:
  /// Subscribes at once. `first_tick` is called on the executor's thread when there is a time: nodes stamp
  /// messages and start timers in initialize(), so a component is not started before.
  SimulatedTime(SimulatedTimeConfig config, Bus& bus, SimulatedClock& clock, ThreadExecutor& executor,
                std::function<void()> first_tick);

 private:
  void tick(const ClockTick& tick);
  void give_credit();

  SimulatedTimeConfig config_;
  SimulatedClock& clock_;
  ThreadExecutor& executor_;
  std::function<void()> first_tick_;
  Publisher<SimCredit> credit_;
  StampNs credited_ns_ = 0;
  bool credit_queued_ = false;
};

}  // namespace enfilade
