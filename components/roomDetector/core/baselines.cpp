// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/baselines.hpp"

#include <algorithm>
#include <cstdlib>

namespace enfilade::room_detector {
namespace {

/// Calls visit(first, second) for every pair of lines within the limits, in order.
template <class Visit>
void for_each_pair(int bins, const WindowLimits& limits, Visit visit) {
  for (int first = 0; first < bins && first <= limits.last_first; ++first) {
    const int last = limits.max_gap < bins - 1 - first ? first + limits.max_gap : bins - 1;
    for (int second = std::max(first + limits.min_gap, limits.first_second); second <= last; ++second)
      visit(first, second);
  }
}

}  // namespace

LiteralHough::LiteralHough(const HoughSpace& space)
    : bins_(space.lattice().bins()), angles_(space.lattice().angles()) {
  table_.assign(static_cast<std::size_t>(table_size(space.lattice())), 0);
  for (const Vote& vote : space.votes()) {
    for (int a = 0; a < angles_ && vote.occupied > 0; ++a) {
      const auto b = space.bins_of(a, vote.position);
      if (!space.lattice().holds(b.d) || !space.lattice().holds(b.p)) continue;
      add(a, b.d, b.p, vote.occupied);
      add(a + angles_, b.p, mirror(b.d), vote.occupied);  // θ = α + π/2: d' = p, p' = -d
    }
  }
}

double LiteralHough::table_size(const HoughLattice& lattice) {
  return 2.0 * lattice.angles() * lattice.bins() * lattice.bins();
}

/// Step f: every H(θ, d, p') with p' from p on.
void LiteralHough::add(int angle, int d, int p, int count) {
  for (int later = p; later < bins_; ++later) table_[index(angle, d, later)] += count;
}

int LiteralHough::score(const BinRectangle& r) const {
  const int a = r.alpha, b = r.alpha + angles_;
  const int h12 = std::abs(h(a, r.d12, r.d41 - 1) - h(a, r.d12, r.d23 - 1));                  // eq. 6
  const int h34 = std::abs(h(a, r.d34, r.d23) - h(a, r.d34, r.d41));                          // eq. 7
  const int h23 = std::abs(h(b, r.d23, mirror(r.d12)) - h(b, r.d23, mirror(r.d34)));          // eq. 8
  const int h41 = std::abs(h(b, r.d41, mirror(r.d34) - 1) - h(b, r.d41, mirror(r.d12) - 1));  // eq. 9
  return h12 + h23 + h34 + h41;                                                               // eq. 5
}

void LiteralHough::search(int angle, const PlaneLimits& limits, Incumbent& best) const {
  for_each_pair(bins_, limits.d, [&](int d12, int d34) {
    for_each_pair(bins_, limits.p, [&](int d41, int d23) {
      const BinRectangle r{angle, d12, d34, d41, d23};
      best.offer(r, score(r));
    });
  });
}

void search_by_lines(const HoughSpace& space, int angle, const PlaneLimits& limits, Incumbent& best) {
  const auto best_pair = [](std::span<const int> sums, const WindowLimits& of) {
    const auto sum = [&](int i) { return sums[static_cast<std::size_t>(i)]; };
    return best_window(static_cast<int>(sums.size()), of, sum, sum);
  };
  const Window d = best_pair(space.sums_by_d(angle), limits.d),
               p = best_pair(space.sums_by_p(angle), limits.p);
  if (d.first >= 0 && p.first >= 0)
    best.offer({angle, d.first, d.second, p.first, p.second}, d.value + p.value);
}

}  // namespace enfilade::room_detector
