// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/simulated_time.hpp"

#include <utility>

#include "interfaces/topics/topics.hpp"

namespace enfilade {

SimulatedTime::SimulatedTime(SimulatedTimeConfig config, Bus& bus, SimulatedClock& clock,
                             ThreadExecutor& executor, std::function<void()> first_tick)
    : config_(std::move(config)),
      clock_(clock),
      executor_(executor),
      first_tick_(std::move(first_tick)),
      credit_(bus.advertise(topics::kSimCredit)) {
  bus.subscribe<ClockTick>(topics::kClock, [this](const ClockTick& message) { tick(message); });
}

void SimulatedTime::tick(const ClockTick& tick) {
  if (tick.now_ns < clock_.now_ns()) credited_ns_ = 0;  // a new simulator
  clock_.set(tick.now_ns);
  const bool first = static_cast<bool>(first_tick_);
  if (first) std::exchange(first_tick_, {})();
  executor_.ticked();
  const bool due = first || tick.now_ns - credited_ns_ >= from_seconds(config_.credit_period_s);
  if (!due || credit_queued_) return;
  credit_queued_ = true;
  executor_.post([this] { give_credit(); });
}

void SimulatedTime::give_credit() {
  credit_queued_ = false;
  credited_ns_ = clock_.now_ns();
  credit_.publish({.component_name = config_.component, .done_ns = credited_ns_});
}

}  // namespace enfilade
