// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "interfaces/runtime/clock.hpp"
#include "interfaces/runtime/executor.hpp"

namespace enfilade {

struct ThreadExecutorConfig {
  int max_queued = 20000;  ///< work waiting; what other threads post beyond that is dropped and counted; >= 1
};

/// One thread that runs a component. every() follows the given clock tick by tick, or wall time without one;
/// every_wall() always follows wall time (the steady clock, which nobody sets).
class ThreadExecutor : public Executor {
 public:
  /// With a `ticking` clock, clock timers are looked at when ticked() is called, and only then.
  explicit ThreadExecutor(const Clock* ticking = nullptr, ThreadExecutorConfig config = {});
  /// Stops, if stop() was not called before.
  ~ThreadExecutor() override;
  ThreadExecutor(const ThreadExecutor&) = delete;
  ThreadExecutor& operator=(const ThreadExecutor&) = delete;

  void start();
  /// After the work at hand nothing runs any more but `last`; then the thread ends. Any thread; the first
  /// call counts.
  void stop(std::function<void()> last = {});
  /// Waits until the thread has ended; false if it has not within `timeout`. Not from the executor's thread.
  bool wait_stopped(std::chrono::milliseconds timeout);

  void post(std::function<void()> work) override;
  /// Before start() or on the executor's thread.
  void every(StampNs period_ns, std::function<void()> work) override;
  void every_wall(StampNs period_ns, std::function<void()> work) override;
  void on_exception(ExceptionHandler handler) override { on_exception_ = std::move(handler); }

  /// The ticking clock has moved: runs the clock timers that are due. On the executor's thread.
  void ticked();

  std::uint64_t dropped() const { return dropped_.load(std::memory_order_relaxed); }

 private:
  using Work = std::function<void()>;
  struct Timer {
    StampNs due_ns;
    StampNs period_ns;
    Work work;
  };
  using Timers = std::deque<Timer>;  // references stay valid while a timer adds timers

  void require_own_thread(const char* call) const;
  static void add(Timers& timers, StampNs now_ns, StampNs period_ns, Work work);
  void run_due(Timers& timers, StampNs now_ns);
  void loop();
  std::optional<Work> wait_for_work();
  void run(const Work& work) const;

  const Clock* ticking_;
  ThreadExecutorConfig config_;
  ExceptionHandler on_exception_;
  Timers clock_timers_, wall_timers_;  // own thread only, once started

  std::mutex mutex_;
  std::condition_variable wake_, ended_wake_;
  std::deque<Work> queue_;
  std::atomic<bool> stopping_ = false;
  bool ended_ = false;
  Work last_;
  std::atomic<std::uint64_t> dropped_ = 0;
  std::atomic<std::thread::id> thread_id_{};
  std::thread thread_;
};

}  // namespace enfilade
