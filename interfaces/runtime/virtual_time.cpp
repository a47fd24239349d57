// SPDX-License-Identifier: Apache-2.0
#include "interfaces/runtime/virtual_time.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace enfilade {

void VirtualScheduler::at(StampNs time_ns, int participant, std::function<void()> work) {
  heap_.push_back({{std::max(time_ns, now_ns_), participant, sequence_++}, std::move(work)});
  std::ranges::push_heap(heap_, later);
}

bool VirtualScheduler::run_next(StampNs deadline_ns) {
  if (heap_.empty() || heap_.front().order.time_ns > deadline_ns) return false;
  std::ranges::pop_heap(heap_, later);
  const Event event = std::move(heap_.back());
  heap_.pop_back();
  now_ns_ = event.order.time_ns;
  event.work();
  return true;
}

bool VirtualScheduler::run_until(const std::function<bool()>& stop, StampNs deadline_ns) {
  while (run_next(deadline_ns)) {
    if (stop && stop()) return true;
  }
  now_ns_ = std::max(now_ns_, deadline_ns);
  return false;
}

struct VirtualExecutor::State : std::enable_shared_from_this<State> {
  State(VirtualScheduler& s, int p) : scheduler(s), participant(p) {}

  void run(const std::function<void()>& work) const {
    try {
      work();
    } catch (...) {
      if (!on_exception) throw;
      on_exception(std::current_exception());
    }
  }

  void at(StampNs time_ns, int writer, std::function<void()> work) {
    scheduler.at(time_ns, writer, [self = weak_from_this(), work = std::move(work)] {
      if (const auto alive = self.lock()) alive->run(work);
    });
  }

  void repeat(StampNs period_ns, std::function<void()> work) {
    const StampNs due_ns = scheduler.now_ns() + period_ns;
    scheduler.at(due_ns, participant, [self = weak_from_this(), period_ns, work = std::move(work)]() mutable {
      const auto alive = self.lock();
      if (!alive) return;
      alive->run(work);
      alive->repeat(period_ns, std::move(work));
    });
  }

  VirtualScheduler& scheduler;
  int participant;
  ExceptionHandler on_exception;
};

VirtualExecutor::VirtualExecutor(VirtualScheduler& scheduler, int participant)
    : state_(std::make_shared<State>(scheduler, participant)) {}

VirtualExecutor::~VirtualExecutor() = default;

void VirtualExecutor::post(std::function<void()> work) { post_from(state_->participant, std::move(work)); }

void VirtualExecutor::post_from(int participant, std::function<void()> work) {
  state_->at(state_->scheduler.now_ns(), participant, std::move(work));
}

void VirtualExecutor::every(StampNs period_ns, std::function<void()> work) {
  if (period_ns <= 0) throw std::logic_error("Executor::every: the period must be positive");
  state_->repeat(period_ns, std::move(work));
}

void VirtualExecutor::on_exception(ExceptionHandler handler) { state_->on_exception = std::move(handler); }

}  // namespace enfilade
