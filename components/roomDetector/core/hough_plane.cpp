// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/hough_plane.hpp"

namespace enfilade::room_detector {

void HoughPlane::build(const HoughSpace& space, int angle) {
  clear(space, angle);
  cast(space);
  if (space.free_map().charges()) charge(space);
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
  for (const HoughSpace::WallVote& vote : space.wall_votes()) has_interior_ |= vote.interior > 0;
  if (has_interior_) interior_.assign(size, 0);
}

void HoughPlane::cast(const HoughSpace& space) {
  const HoughLattice& lattice = space.lattice();
  for (const HoughSpace::WallVote& vote : space.wall_votes()) {
    const auto b = space.bins_at(alpha_, vote.x_m, vote.y_m);
    if (!lattice.holds(b.d) || !lattice.holds(b.p)) continue;
    along_p_[at(b.d, b.p)] += vote.occupied;
    if (has_interior_) interior_[at(b.d, b.p)] += vote.interior;
  }
}

void HoughPlane::charge(const HoughSpace& space) {
  const HoughSpace::BinCentres centres = space.bin_centres(alpha_);
  for (int d = 0; d < bins_; ++d) {
    for (int p = 0; p < bins_; ++p)
      along_p_[at(d, p)] -= space.free_map().charge_at(centres.x_at(d, p), centres.y_at(d, p));
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

int HoughPlane::score(const BinRectangle& r) const {
  const int h12 = along_p(r.d12, r.d23) - along_p(r.d12, r.d41);          // eq. 6: d41 ≤ p < d23
  const int h23 = along_d(r.d34, r.d23) - along_d(r.d12, r.d23);          // eq. 8: d12 ≤ d < d34
  const int h34 = along_p(r.d34, r.d23 + 1) - along_p(r.d34, r.d41 + 1);  // eq. 7: d41 < p ≤ d23
  const int h41 = along_d(r.d34 + 1, r.d41) - along_d(r.d12 + 1, r.d41);  // eq. 9: d12 < d ≤ d34
  const int inside = interior_below(r.d12, r.d34, r.d23) - interior_above(r.d12, r.d34, r.d41);
  const int contour_bins = 2 * (r.d34 - r.d12 + r.d23 - r.d41);
  return h12 + h23 + h34 + h41 - inside - toll_ * contour_bins;  // eq. 5
}

}  // namespace enfilade::room_detector
