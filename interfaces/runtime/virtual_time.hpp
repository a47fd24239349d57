// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "interfaces/runtime/clock.hpp"
#include "interfaces/runtime/executor.hpp"

namespace enfilade {

/// All that happens in a composed run, one event after the other, ordered by (time, participant, sequence).
/// Single threaded.
class VirtualScheduler {
 public:
  StampNs now_ns() const { return now_ns_; }

  /// Runs `work` at `time_ns`, or now if that is past.
  void at(StampNs time_ns, int participant, std::function<void()> work);

  /// Runs the next event if it is due by `deadline_ns`; false if there is none.
  bool run_next(StampNs deadline_ns);

  /// Runs events until `stop()` holds after one of them (true), or all that are due by `deadline_ns` have run
  /// (false; the time is then `deadline_ns`).
  bool run_until(const std::function<bool()>& stop, StampNs deadline_ns);

 private:
  struct Order {
    StampNs time_ns;
    int participant;
    std::uint64_t sequence;
    auto operator<=>(const Order&) const = default;
  };
  struct Event {
    Order order;
    std::function<void()> work;
  };
  static bool later(const Event& a, const Event& b) { return a.order > b.order; }

  StampNs now_ns_ = 0;
  std::uint64_t sequence_ = 0;
  std::vector<Event> heap_;  // the earliest in front
};

class VirtualClock : public Clock {
 public:
  explicit VirtualClock(const VirtualScheduler& scheduler) : scheduler_(scheduler) {}
  StampNs now_ns() const override { return scheduler_.now_ns(); }

 private:
  const VirtualScheduler& scheduler_;
};

/// One participant's share of the scheduler. What it was given dies with it.
class VirtualExecutor : public Executor {
 public:
  VirtualExecutor(VirtualScheduler& scheduler, int participant);
  ~VirtualExecutor() override;
  VirtualExecutor(const VirtualExecutor&) = delete;
  VirtualExecutor& operator=(const VirtualExecutor&) = delete;

  void post(std::function<void()> work) override;
  void every(StampNs period_ns, std::function<void()> work) override;
  void every_wall(StampNs, std::function<void()>) override {}
  /// Without a handler an exception leaves VirtualScheduler::run_next().
  void on_exception(ExceptionHandler handler) override;

  /// post() on behalf of another participant, whose index then orders the event.
  void post_from(int participant, std::function<void()> work);

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace enfilade
