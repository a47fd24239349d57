// SPDX-License-Identifier: Apache-2.0
#include "interfaces/dds/inbox.hpp"

#include <utility>

namespace enfilade {

Inbox::Inbox(Executor& executor, std::shared_ptr<Gate> gate, std::size_t depth, Handler handler)
    : executor_(executor), gate_(std::move(gate)), depth_(depth), handler_(std::move(handler)) {}

void Inbox::push(AnyMessage message) {
  {
    const std::lock_guard lock(mutex_);
    queue_.push_back(std::move(message));
    if (queue_.size() > depth_) {
      queue_.pop_front();
      ++overflowed_;
      return;  // the delivery posted for the oldest serves the newest
    }
  }
  executor_.post([self = shared_from_this()] { self->gate_->pass([&self] { self->deliver_one(); }); });
}

std::uint64_t Inbox::overflowed() const {
  const std::lock_guard lock(mutex_);
  return overflowed_;
}

void Inbox::deliver_one() {
  AnyMessage message;
  {
    const std::lock_guard lock(mutex_);
    if (queue_.empty()) return;
    message = std::move(queue_.front());
    queue_.pop_front();
  }
  handler_(message);
}

}  // namespace enfilade
