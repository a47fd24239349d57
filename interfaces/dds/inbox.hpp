// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>

#include "interfaces/bus/bus.hpp"
#include "interfaces/runtime/executor.hpp"

namespace enfilade {

/// Stands between a bus and its executor: what runs through it stops for good when the bus closes it.
class Gate {
 public:
  /// Runs `work`, unless closed. close() called meanwhile from another thread waits for its end.
  void pass(const std::function<void()>& work) {
    const std::lock_guard lock(mutex_);
    if (open_) work();
  }
  void close() {
    const std::lock_guard lock(mutex_);
    open_ = false;
  }

 private:
  std::recursive_mutex mutex_;  // a handler may end its own bus
  bool open_ = true;
};

/// Messages of one subscription on their way from Fast DDS's threads to the executor: at most `depth`, the
/// oldest give way.
class Inbox : public std::enable_shared_from_this<Inbox> {
 public:
  using Handler = std::function<void(const AnyMessage&)>;

  Inbox(Executor& executor, std::shared_ptr<Gate> gate, std::size_t depth, Handler handler);

  void push(AnyMessage message);
  std::uint64_t overflowed() const;

 private:
  void deliver_one();

  Executor& executor_;
  std::shared_ptr<Gate> gate_;
  std::size_t depth_;
  Handler handler_;
  mutable std::mutex mutex_;
  std::deque<AnyMessage> queue_;  ///< as long as the number of deliveries posted
  std::uint64_t overflowed_ = 0;
};

}  // namespace enfilade
