// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/hough_space.hpp"

namespace enfilade::room_detector {

HoughSpace::HoughSpace(const HoughConfig& config, const Point2& origin) : lattice_(config), origin_(origin) {
  for (int a = 0; a < lattice_.angles(); ++a) {
    directions_.push_back({std::cos(lattice_.alpha_rad(a)), std::sin(lattice_.alpha_rad(a))});
  }
  sums_by_d_.assign(offset(lattice_.angles()), 0);
  sums_by_p_.assign(offset(lattice_.angles()), 0);
}

void HoughSpace::set(std::size_t index, const Vote& vote) {
  if (index >= votes_.size()) votes_.resize(index + 1);
  Vote& old = votes_[index];
  if (old.occupied != 0 && old.position != vote.position) {
    add(old.position, -old.occupied);
    old.occupied = 0;
  }
  if (vote.occupied != old.occupied) add(vote.position, vote.occupied - old.occupied);
  old = vote;
}

void HoughSpace::add(const Point2& position, int occupied) {
  for (int a = 0; a < lattice_.angles(); ++a) {
    const Bins b = bins_of(a, position);
    if (!lattice_.holds(b.d) || !lattice_.holds(b.p)) continue;
    sums_by_d_[offset(a) + static_cast<std::size_t>(b.d)] += occupied;
    sums_by_p_[offset(a) + static_cast<std::size_t>(b.p)] += occupied;
  }
}

Rectangle HoughSpace::rectangle(const BinRectangle& r) const {
  return Pose2{origin_.x(), origin_.y(), 0.0} * lattice_.rectangle(r);
}

}  // namespace enfilade::room_detector
