// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace enfilade::room_detector {

/// Which pairs (first, second) of a window search count: first ≤ last_first, second ≥ first_second, and their
/// distance.
struct WindowLimits {
  int last_first = std::numeric_limits<int>::max();
  int first_second = 0;
  int min_gap = 1;
  int max_gap = std::numeric_limits<int>::max();
};

/// Less than any score, and safe to add up.
inline constexpr int kNever = -(1 << 28);

struct Window {
  int value = kNever / 2;  ///< this where no pair counts
  int first = -1, second = -1;
};

/// max of f(i) + g(j) over all pairs 0 ≤ i < j < n within the limits, in O(n): a queue of the candidates for
/// i, falling in f, slides along with j. Of equal pairs the one with the smallest i, then the smallest j. A
/// kNever of f or g never wins.
template <class First, class Second>
Window best_window(int n, const WindowLimits& limits, First f, Second g) {
  std::vector<std::pair<int, int>> queue(static_cast<std::size_t>(n));  // (i, f(i))
  std::size_t head = 0, tail = 0;
  Window best;
  for (int j = std::max(limits.first_second, limits.min_gap), next = 0; j < n; ++j) {
    for (const int last = std::min(j - limits.min_gap, limits.last_first); next <= last; ++next) {
      const int value = f(next);
      while (tail > head && queue[tail - 1].second < value) --tail;
      queue[tail++] = {next, value};
    }
    while (tail > head && queue[head].first < j - limits.max_gap) ++head;
    if (tail == head) continue;
    const auto [i, value] = queue[head];
    const int sum = value + g(j);
    if (sum > best.value || (sum == best.value && i < best.first)) best = {sum, i, j};
  }
  return best;
}

}  // namespace enfilade::room_detector
