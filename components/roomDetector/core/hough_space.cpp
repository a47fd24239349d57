// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/hough_space.hpp"

#include <bit>

namespace enfilade::room_detector {
namespace {

constexpr int kBeyond_bins = 9;  // that blocks of bins may reach beyond the space

std::uint64_t mix(std::uint64_t h, std::uint64_t value) {
  h = (h ^ value) * 0x9e3779b97f4a7c15u;
  return h ^ h >> 29;
}

std::uint64_t fingerprint_of(std::size_t index, const Vote& vote) {
  if (vote.occupied == 0 && vote.free == 0 && vote.interior == 0) return 0;
  std::uint64_t h = mix(1, index);
  for (const double x : {vote.position.x(), vote.position.y()}) h = mix(h, std::bit_cast<std::uint64_t>(x));
  for (const int n : {vote.occupied, vote.free, vote.interior}) h = mix(h, static_cast<std::uint32_t>(n));
  return h;
}

}  // namespace

HoughSpace::HoughSpace(const HoughConfig& config, const Point2& origin, double cell_m)
    : lattice_(config),
      origin_(origin),
      free_map_(cell_m, origin, std::sqrt(2.0) * (config.range_m + kBeyond_bins * config.step_m)) {
  for (int a = 0; a < lattice_.angles(); ++a) {
    directions_.push_back({std::cos(lattice_.alpha_rad(a)), std::sin(lattice_.alpha_rad(a))});
  }
  sums_by_d_.assign(offset(lattice_.angles()), 0);
  sums_by_p_.assign(offset(lattice_.angles()), 0);
}

void HoughSpace::set_penalties(const Penalties& penalties) {
  penalties_ = penalties;
  free_map_.set_rule(penalties.per_free, penalties.near_cells);
}

void HoughSpace::set(std::size_t index, const Vote& vote) {
  if (index >= votes_.size()) {
    votes_.resize(index + 1);
    wall_vote_of_.resize(index + 1, -1);
  }
  Vote& old = votes_[index];
  if (old == vote) return;
  fingerprint_ += fingerprint_of(index, vote) - fingerprint_of(index, old);
  if (old.position != vote.position) {
    if (old.occupied != 0) add(old.position, -old.occupied);
    free_map_.add(old.position, -old.free, -(old.occupied > 0));
    old.occupied = old.free = 0;
  }
  if (vote.occupied != old.occupied) add(vote.position, vote.occupied - old.occupied);
  const int more_free = vote.free - old.free, more_occupied = (vote.occupied > 0) - (old.occupied > 0);
  if (more_free != 0 || more_occupied != 0) free_map_.add(vote.position, more_free, more_occupied);
  old = vote;
  keep_wall_vote(index, vote);
}

void HoughSpace::keep_wall_vote(std::size_t index, const Vote& vote) {
  std::int32_t& slot = wall_vote_of_[index];
  if (vote.occupied == 0 && vote.interior == 0) {
    if (slot < 0) return;
    wall_votes_[static_cast<std::size_t>(slot)] = wall_votes_.back();
    voter_[static_cast<std::size_t>(slot)] = voter_.back();
    wall_vote_of_[voter_.back()] = slot;
    wall_votes_.pop_back();
    voter_.pop_back();
    slot = -1;
    return;
  }
  if (slot < 0) {
    slot = static_cast<std::int32_t>(wall_votes_.size());
    wall_votes_.emplace_back();
    voter_.push_back(index);
  }
  const Point2 q = vote.position - origin_;
  wall_votes_[static_cast<std::size_t>(slot)] = {q.x(), q.y(), vote.occupied, vote.interior};
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

HoughSpace::BinCentres HoughSpace::bin_centres(int angle) const {
  const Direction& n = directions_[static_cast<std::size_t>(angle)];
  const double first = lattice_.value_m(0), by_bin = FreeMap::kOne * lattice_.step_m() / free_map_.cell_m();
  const auto fixed = [](double value) { return static_cast<std::int32_t>(std::lround(value)); };
  return {fixed(free_map_.fixed_x(origin_.x() + first * (n.cos - n.sin))),
          fixed(free_map_.fixed_y(origin_.y() + first * (n.sin + n.cos))), fixed(by_bin * n.cos),
          fixed(by_bin * n.sin)};
}

HoughSpace::Terms HoughSpace::terms(const BinRectangle& r) const {
  std::array<int, 4> walls{};
  int inside = 0;
  const int margin = penalties_.contour_bins;
  for (const WallVote& vote : wall_votes_) {
    const Bins b = bins_at(r.alpha, vote.x_m, vote.y_m);
    if (b.d < r.d12 || b.d > r.d34 || b.p < r.d41 || b.p > r.d23) continue;
    if (b.d == r.d12 && b.p < r.d23) walls[0] += vote.occupied;  // eq. 6
    if (b.p == r.d23 && b.d < r.d34) walls[1] += vote.occupied;  // eq. 8
    if (b.d == r.d34 && b.p > r.d41) walls[2] += vote.occupied;  // eq. 7
    if (b.p == r.d41 && b.d > r.d12) walls[3] += vote.occupied;  // eq. 9
    const bool is_inside =
        b.d > r.d12 + margin && b.d < r.d34 - margin && b.p > r.d41 + margin && b.p < r.d23 - margin;
    if (is_inside) inside += vote.interior;
  }
  charge(r, walls);
  const int contour = 2 * (r.d34 - r.d12 + r.d23 - r.d41);
  const int on_walls = walls[0] + walls[1] + walls[2] + walls[3];
  return {walls, on_walls - inside - penalties_.per_bin * contour};  // eq. 5
}

/// Takes off what is free under the contour.
void HoughSpace::charge(const BinRectangle& r, std::array<int, 4>& walls) const {
  if (!free_map_.charges()) return;
  const BinCentres at = bin_centres(r.alpha);
  const auto charge_at = [&](int d, int p) { return free_map_.charge_at(at.x_at(d, p), at.y_at(d, p)); };
  for (int p = r.d41; p < r.d23; ++p) {
    walls[0] -= charge_at(r.d12, p);
    walls[2] -= charge_at(r.d34, p + 1);
  }
  for (int d = r.d12; d < r.d34; ++d) {
    walls[1] -= charge_at(d, r.d23);
    walls[3] -= charge_at(d + 1, r.d41);
  }
}

}  // namespace enfilade::room_detector
