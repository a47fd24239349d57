// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/thread_executor.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace enfilade {
namespace {

using SteadyTime = std::chrono::steady_clock::time_point;

StampNs steady_now_ns() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

}  // namespace

ThreadExecutor::ThreadExecutor(const Clock* ticking, ThreadExecutorConfig config)
    : ticking_(ticking), config_(config) {
  if (config_.max_queued < 1)
    throw std::invalid_argument("ThreadExecutorConfig: max_queued must be at least 1");
}

ThreadExecutor::~ThreadExecutor() {
  stop();
  if (thread_.joinable()) thread_.join();
}

void ThreadExecutor::start() {
  thread_ = std::thread([this] { loop(); });
  thread_id_ = thread_.get_id();
}

void ThreadExecutor::stop(std::function<void()> last) {
  {
    const std::lock_guard lock(mutex_);
    if (stopping_) return;
    stopping_ = true;
    last_ = std::move(last);
  }
  wake_.notify_all();
}

bool ThreadExecutor::wait_stopped(std::chrono::milliseconds timeout) {
  std::unique_lock lock(mutex_);
  return ended_wake_.wait_for(lock, timeout, [this] { return ended_; });
}

void ThreadExecutor::post(std::function<void()> work) {
  {
    const std::lock_guard lock(mutex_);
    // What the component posts to itself is never dropped: there the queue is bounded by the component's own
    // logic.
    const bool own = std::this_thread::get_id() == thread_id_;
    if (!own && queue_.size() >= static_cast<std::size_t>(config_.max_queued)) {
      dropped_.fetch_add(1, std::memory_order_relaxed);
      return;
    }
    queue_.push_back(std::move(work));
  }
  wake_.notify_one();
}

void ThreadExecutor::every(StampNs period_ns, std::function<void()> work) {
  require_own_thread("every");
  if (ticking_) {
    add(clock_timers_, ticking_->now_ns(), period_ns, std::move(work));
  } else {
    add(wall_timers_, steady_now_ns(), period_ns, std::move(work));
  }
}

void ThreadExecutor::every_wall(StampNs period_ns, std::function<void()> work) {
  require_own_thread("every_wall");
  add(wall_timers_, steady_now_ns(), period_ns, std::move(work));
}

void ThreadExecutor::ticked() {
  if (ticking_) run_due(clock_timers_, ticking_->now_ns());
}

void ThreadExecutor::require_own_thread(const char* call) const {
  const std::thread::id owner = thread_id_;
  if (owner == std::thread::id{} || owner == std::this_thread::get_id()) return;
  throw std::logic_error(std::string("Executor::") + call + " is for the component's own thread");
}

void ThreadExecutor::add(Timers& timers, StampNs now_ns, StampNs period_ns, Work work) {
  if (period_ns <= 0) throw std::logic_error("Executor::every: the period must be positive");
  timers.push_back({now_ns + period_ns, period_ns, std::move(work)});
}

void ThreadExecutor::run_due(Timers& timers, StampNs now_ns) {
  for (std::size_t i = 0; i < timers.size() && !stopping_; ++i) {
    Timer& timer = timers[i];
    // A clock that was set back, as by a simulator that started anew, begins a new period.
    if (timer.due_ns > now_ns + timer.period_ns) timer.due_ns = now_ns + timer.period_ns;
    if (timer.due_ns > now_ns) continue;
    // Periods missed altogether are skipped; those to come keep their phase.
    timer.due_ns += timer.period_ns * (1 + (now_ns - timer.due_ns) / timer.period_ns);
    run(timer.work);
  }
}

void ThreadExecutor::loop() {
  thread_id_ = std::this_thread::get_id();
  while (const auto work = wait_for_work()) {
    if (*work) run(*work);
    run_due(wall_timers_, steady_now_ns());
  }
  if (last_) run(last_);
  const std::lock_guard lock(mutex_);
  ended_ = true;
  ended_wake_.notify_all();
}

/// The next work; an empty one when a timer is due; nothing when it is time to stop.
std::optional<ThreadExecutor::Work> ThreadExecutor::wait_for_work() {
  StampNs due_ns = std::numeric_limits<StampNs>::max();
  for (const Timer& timer : wall_timers_) due_ns = std::min(due_ns, timer.due_ns);
  const auto ready = [this] { return stopping_ || !queue_.empty(); };
  std::unique_lock lock(mutex_);
  if (wall_timers_.empty()) {
    wake_.wait(lock, ready);
  } else {
    wake_.wait_until(lock, SteadyTime(std::chrono::nanoseconds(due_ns)), ready);
  }
  if (stopping_) return std::nullopt;
  if (queue_.empty()) return Work{};
  Work work = std::move(queue_.front());
  queue_.pop_front();
  return work;
}

void ThreadExecutor::run(const Work& work) const {
  try {
    work();
  } catch (...) {
    if (!on_exception_) throw;
    on_exception_(std::current_exception());
  }
}

}  // namespace enfilade
