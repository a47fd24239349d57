// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <vector>

#include <benchmark/benchmark.h>
#include <time.h>

namespace enfilade::bench {

/// Milliseconds this thread has computed; what other programs do meanwhile does not count.
inline double thread_ms() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e3 * static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_nsec);
}

inline double wall_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// How long each of many inputs takes: of the passes over all of them the quickest counts.
class InputTimes {
 public:
  /// Work shared out to several threads needs `clock` = wall_ms.
  explicit InputTimes(double (*clock)() = thread_ms) : clock_(clock) {}

  template <class Work>
  void measure(std::size_t input, Work&& work) {
    const double start_ms = clock_();
    work();
    if (input >= best_ms_.size()) best_ms_.resize(input + 1, std::numeric_limits<double>::max());
    best_ms_[input] = std::min(best_ms_[input], clock_() - start_ms);
  }

  /// Counters `median_ms`, `max_ms` and `inputs`.
  void report(benchmark::State& state) {
    if (best_ms_.empty()) return;
    std::sort(best_ms_.begin(), best_ms_.end());
    state.counters["median_ms"] = best_ms_[best_ms_.size() / 2];
    state.counters["p95_ms"] = best_ms_[best_ms_.size() * 95 / 100];
    state.counters["max_ms"] = best_ms_.back();
    state.counters["inputs"] = static_cast<double>(best_ms_.size());
  }

 private:
  double (*clock_)();
  std::vector<double> best_ms_;
};

}  // namespace enfilade::bench
