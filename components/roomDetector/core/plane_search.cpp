// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/plane_search.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace enfilade::room_detector {
namespace {

/// The best pair of parallel lines by their sums alone. Each bin of distance between them costs the other two
/// walls a toll.
Window best_pair(std::span<const int> sums, const WindowLimits& limits, int cost_per_bin) {
  return best_window(
      static_cast<int>(sums.size()), limits,
      [&](int i) { return sums[static_cast<std::size_t>(i)] + cost_per_bin * i; },
      [&](int j) { return sums[static_cast<std::size_t>(j)] - cost_per_bin * j; });
}

/// For given d₁₂ and d₃₄, eq. 5 falls apart into one term of d₂₃ and one of d₄₁: O(N) for all pairs of them.
void search_lines(const HoughPlane& plane, int d12, int d34, const WindowLimits& limits, Incumbent& best) {
  ++best.expansions;
  const int toll = 2 * plane.toll();
  const auto of_d41 = [&](int p) {
    return -plane.along_p(d12, p) - plane.along_p(d34, p + 1) + plane.along_d(d34 + 1, p) -
           plane.along_d(d12 + 1, p) + plane.interior_above(d12, d34, p) + toll * p;
  };
  const auto of_d23 = [&](int p) {
    return plane.along_p(d12, p) + plane.along_p(d34, p + 1) + plane.along_d(d34, p) - plane.along_d(d12, p) -
           plane.interior_below(d12, d34, p) - toll * p;
  };
  const Window found = best_window(plane.bins(), limits, of_d41, of_d23);
  if (found.first < 0) return;
  best.offer({plane.alpha(), d12, d34, found.first, found.second}, found.value - toll * (d34 - d12));
}

/// The half-open stretches of a line that a wall can be: those of either counting (see HoughPlane).
WindowLimits stretches(const WindowLimits& corners) {
  WindowLimits limits = corners;
  if (limits.last_first < std::numeric_limits<int>::max()) ++limits.last_first;
  return limits;
}

/// The most a wall on line d (or p) can hold, toll deducted.
template <class Cumulative>
int best_stretch(int bins, const WindowLimits& limits, int toll, Cumulative cumulative) {
  return best_window(
             bins + 1, stretches(limits), [&](int a) { return toll * a - cumulative(a); },
             [&](int b) { return cumulative(b) - toll * b; })
      .value;
}

/// Upper bounds of the walls on each line of one direction; kNever for lines that cannot be part of a winner
/// because even with the best partner and the best pair across (`others`) their sum stays below the
/// incumbent.
template <class Stretch>
std::vector<int> wall_bounds(std::span<const int> sums, int others, Incumbent& best, Stretch stretch) {
  const int partner = *std::max_element(sums.begin(), sums.end());
  std::vector<int> bounds(sums.size(), kNever);
  for (std::size_t line = 0; line < sums.size(); ++line) {
    if (sums[line] + partner + others < best.score) continue;
    bounds[line] = stretch(static_cast<int>(line));
    ++best.expansions;
  }
  return bounds;
}

struct Pair {
  int bound, d12, d34;
};

/// All (d₁₂, d₃₄) that can still win, best bound first.
std::vector<Pair> promising_pairs(const std::vector<int>& walls, int across, const WindowLimits& limits,
                                  int score) {
  std::vector<Pair> pairs;
  const int n = static_cast<int>(walls.size());
  for (int i = 0; i < n && i <= limits.last_first; ++i) {
    const int one = walls[static_cast<std::size_t>(i)];
    if (one <= kNever / 2) continue;
    const int last = limits.max_gap < n - 1 - i ? i + limits.max_gap : n - 1;
    for (int j = std::max(i + limits.min_gap, limits.first_second); j <= last; ++j) {
      const int bound = one + walls[static_cast<std::size_t>(j)] + across;
      if (bound >= score && bound > kNever / 2) pairs.push_back({bound, i, j});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.bound > b.bound; });
  return pairs;
}

}  // namespace

PlaneBound bound_of(const HoughSpace& space, int angle, const PlaneLimits& limits) {
  const int cost = 2 * space.penalties().per_bin;
  return {best_pair(space.sums_by_d(angle), limits.d, cost).value,
          best_pair(space.sums_by_p(angle), limits.p, cost).value};
}

void search_plane(const HoughPlane& plane, const HoughSpace& space, const PlaneLimits& limits,
                  Incumbent& best) {
  const int n = plane.bins(), toll = plane.toll();
  const auto by_d = space.sums_by_d(plane.alpha()), by_p = space.sums_by_p(plane.alpha());
  const Window start = best_pair(by_d, limits.d, 2 * toll);
  const Window across = best_pair(by_p, limits.p, 2 * toll);
  if (start.first < 0 || across.first < 0) return;
  search_lines(plane, start.first, start.second, limits.p, best);

  const auto walls_p = wall_bounds(by_p, start.value, best, [&](int p) {
    return best_stretch(n, limits.d, toll, [&](int d) { return plane.along_d(d, p); });
  });
  const int best_across = best_pair(walls_p, limits.p, 0).value;
  const auto walls_d = wall_bounds(by_d, best_across, best, [&](int d) {
    return best_stretch(n, limits.p, toll, [&](int p) { return plane.along_p(d, p); });
  });
  for (const Pair& pair : promising_pairs(walls_d, best_across, limits.d, best.score)) {
    if (!best.may_lose_to(pair.bound, {plane.alpha(), pair.d12, pair.d34, 0, 0})) continue;
    if (!best.has_budget()) {
      best.gap_bound = std::max(best.gap_bound, pair.bound);
      return;
    }
    search_lines(plane, pair.d12, pair.d34, limits.p, best);
  }
}

}  // namespace enfilade::room_detector
