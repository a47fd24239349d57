// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/hough_plane.hpp"

namespace enfilade::room_detector {

void HoughPlane::build(const HoughSpace& space, int angle) {
  clear(space, angle);
  cast(space);
  if (space.penalties().per_free > 0.0) charge_for_free(space.penalties());
  accumulate();
  if (has_interior_) accumulate_interior();
}

void HoughPlane::clear(const HoughSpace& space, int angle) {
  bins_ = space.lattice().bins();
  alpha_ = angle;
  toll_ = space.penalties().per_bin;
  margin_ = space.penalties().contour_bins;
  const std::size_t size = at(bins_ + 1, 0);
  along_p_.assign(size, 0);
  along_d_.resize(size);
  has_interior_ = false;
  for (const Vote& vote : space.votes()) has_interior_ |= vote.interior > 0;
  if (has_interior_) interior_.assign(size, 0);
}

void HoughPlane::cast(const HoughSpace& space) {
  const HoughLattice& lattice = space.lattice();
  const bool wants_free = space.penalties().per_free > 0.0;
  if (wants_free) free_.assign(along_p_.size(), 0);
  for (const Vote& vote : space.votes()) {
    if (vote.occupied + vote.free + vote.interior == 0) continue;
    const auto b = space.bins_of(alpha_, vote.position);
    if (!lattice.holds(b.d) || !lattice.holds(b.p)) continue;
    along_p_[at(b.d, b.p)] += vote.occupied;
    if (wants_free) free_[at(b.d, b.p)] += vote.free;
    if (has_interior_) interior_[at(b.d, b.p)] += vote.interior;
  }
}

void HoughPlane::charge_for_free(const Penalties& penalties) {
  mark_near(penalties.near_bins);
  for (std::size_t i = 0; i < free_.size(); ++i) {
    if (is_near_[i] == 0 && free_[i] > 0)
      along_p_[i] = -static_cast<int>(std::lround(penalties.per_free * free_[i]));
  }
}

void HoughPlane::mark_near(int near_bins) {
  is_near_.assign(along_p_.size(), 0);
  for (int d = 0; d < bins_; ++d) {
    for (int p = 0; p < bins_; ++p) {
      if (along_p_[at(d, p)] == 0) continue;
      for (int i = std::max(0, d - near_bins); i <= std::min(bins_ - 1, d + near_bins); ++i) {
        for (int j = std::max(0, p - near_bins); j <= std::min(bins_ - 1, p + near_bins); ++j)
          is_near_[at(i, j)] = 1;
      }
    }
  }
}

void HoughPlane::accumulate() {
  for (int p = 0; p <= bins_; ++p) along_d_[at(0, p)] = 0;
  for (int d = 0; d < bins_; ++d) {
    int sum = 0;
    for (int p = 0; p <= bins_; ++p) {
      const int weight = along_p_[at(d, p)];
      along_d_[at(d + 1, p)] = along_d_[at(d, p)] + weight;
      along_p_[at(d, p)] = sum;
      sum += weight;
    }
  }
}

void HoughPlane::accumulate_interior() {
  std::vector<int> above(static_cast<std::size_t>(bins_ + 1), 0);  // Σ over d' < d of each p
  for (int d = 0; d <= bins_; ++d) {
    int sum = 0;
    for (int p = 0; p <= bins_; ++p) {
      int& of_p = above[static_cast<std::size_t>(p)];
      const int vote = interior_[at(d, p)];
      interior_[at(d, p)] = sum;
      sum += of_p;
      of_p += vote;
    }
  }
}

std::array<int, 4> HoughPlane::walls(const BinRectangle& r) const {
  return {along_p(r.d12, r.d23) - along_p(r.d12, r.d41),           // eq. 6: d41 ≤ p < d23
          along_d(r.d34, r.d23) - along_d(r.d12, r.d23),           // eq. 8: d12 ≤ d < d34
          along_p(r.d34, r.d23 + 1) - along_p(r.d34, r.d41 + 1),   // eq. 7: d41 < p ≤ d23
          along_d(r.d34 + 1, r.d41) - along_d(r.d12 + 1, r.d41)};  // eq. 9: d12 < d ≤ d34
}

int HoughPlane::score(const BinRectangle& r) const {
  const auto [h12, h23, h34, h41] = walls(r);
  const int inside = interior_below(r.d12, r.d34, r.d23) - interior_above(r.d12, r.d34, r.d41);
  const int contour_bins = 2 * (r.d34 - r.d12 + r.d23 - r.d41);
  return h12 + h23 + h34 + h41 - inside - toll_ * contour_bins;  // eq. 5
}

}  // namespace enfilade::room_detector
