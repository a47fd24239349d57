// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/near_votes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace enfilade::room_detector {

namespace {

/// Where to put the i-th of `count`, so that neighbours come far apart: adding to one sum many times in a row
/// is slow.
int spread(int i, int count) {
  constexpr int kRuns = 8;
  const int run = i % kRuns, rest = count % kRuns;
  return run * (count / kRuns) + std::min(run, rest) + i / kRuns;
}

}  // namespace

void NearVotes::gather(const HoughSpace& space, const Point2& robot, int reach_bins, int most_of_line) {
  choose_scale(space, reach_bins, most_of_line);
  const auto& votes = space.wall_votes();
  const Point2 centre = robot - space.origin();
  const double rings_per_m = 1.0 / (kRing_bins * space.lattice().step_m());
  const int rings = static_cast<int>(std::sqrt(2.0) * (reach_bins + 1) / kRing_bins) + 1;
  ring_of_.resize(votes.size());
  before_ring_.assign(static_cast<std::size_t>(rings) + 2, 0);
  double farthest = 0.0;
  for (std::size_t i = 0; i < votes.size(); ++i) {
    const double away = (Point2(votes[i].x_m, votes[i].y_m) - centre).norm() * rings_per_m;
    ring_of_[i] = away < rings ? static_cast<int>(away) : rings;
    if (ring_of_[i] < rings) farthest = std::max(farthest, away);
    ++before_ring_[static_cast<std::size_t>(ring_of_[i]) + 1];
  }
  std::partial_sum(before_ring_.begin(), before_ring_.end(), before_ring_.begin());
  before_ring_.pop_back();  // votes too far away
  farthest_bins_ = static_cast<int>(farthest * kRing_bins) + 1;
  sort(votes, rings);
  speak_against_ = std::ranges::any_of(interior_, [](int interior) { return interior != 0; });
}

/// Rounding up adds less than one unit for each vote, and each cell has one.
void NearVotes::choose_scale(const HoughSpace& space, int reach_bins, int most_of_line) {
  constexpr int kMost = 15'000;
  scale_bits_ = 0;
  while (most_of_line >> scale_bits_ > kMost) ++scale_bits_;
  const double cells_across = space.lattice().step_m() / space.free_map().cell_m() + 1.0;
  fit_strips_ = scale_bits_ == 0 || 2.0 * reach_bins * cells_across * cells_across < kMost;
}

void NearVotes::sort(const std::vector<HoughSpace::WallVote>& votes, int rings) {
  const auto count = static_cast<std::size_t>(before_ring_.back());
  x_m_.resize(count);
  y_m_.resize(count);
  scaled_.resize(count);
  occupied_.resize(count);
  interior_.resize(count);
  std::vector<int> placed(static_cast<std::size_t>(rings), 0);
  const int one_less = (1 << scale_bits_) - 1;
  for (std::size_t i = 0; i < votes.size(); ++i) {
    const auto ring = static_cast<std::size_t>(ring_of_[i]);
    if (ring == placed.size()) continue;
    const int first = before_ring_[ring], size = before_ring_[ring + 1] - first;
    const auto at = static_cast<std::size_t>(first + spread(placed[ring]++, size));
    x_m_[at] = votes[i].x_m;
    y_m_[at] = votes[i].y_m;
    scaled_[at] = static_cast<std::int16_t>((votes[i].occupied + one_less) >> scale_bits_);
    occupied_[at] = votes[i].occupied;
    interior_[at] = votes[i].interior;
  }
}

int NearVotes::count_within(double bins) const {
  const auto ring = static_cast<std::size_t>((bins + 1.5) / kRing_bins) + 1;
  return before_ring_[std::min(ring, before_ring_.size() - 1)];
}

}  // namespace enfilade::room_detector
