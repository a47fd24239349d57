// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
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

/// How long each of many inputs takes: of the passes over all of them the quickest counts.
class InputTimes {
 public:
  template <class Work>
  void measure(std::size_t input, Work&& work) {
    const double start_ms = thread_ms();
    work();
    if (input >= best_ms_.size()) best_ms_.resize(input + 1, std::numeric_limits<double>::max());
    best_ms_[input] = std::min(best_ms_[input], thread_ms() - start_ms);
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
  std::vector<double> best_ms_;
};

}  // namespace enfilade::bench
