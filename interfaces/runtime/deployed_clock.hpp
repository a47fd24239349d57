// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>

#include "interfaces/runtime/clock.hpp"

namespace enfilade {

/// Wall time since the epoch.
class SystemClock : public Clock {
 public:
  StampNs now_ns() const override {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
  }
};

/// The time of the last rt/clock; 0 before the first. For any thread.
class SimulatedClock : public Clock {
 public:
  StampNs now_ns() const override { return now_ns_.load(std::memory_order_acquire); }
  void set(StampNs now_ns) { now_ns_.store(now_ns, std::memory_order_release); }

 private:
  std::atomic<StampNs> now_ns_{0};
};

}  // namespace enfilade
