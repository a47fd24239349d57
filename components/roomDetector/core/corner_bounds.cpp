// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/corner_bounds.hpp"

#include <algorithm>

#include "components/roomDetector/core/square_charges.hpp"

namespace enfilade::room_detector {
namespace {

constexpr int kFarBlock = 5 * CornerBounds::kBlock;

bool is_far(const LineBlock& block) { return block.farthest - block.nearest >= CornerBounds::kBlock; }

}  // namespace

CornerChoice CornerBounds::everything(const Reaches& reaches, int near_bins) {
  LineBlocks blocks;
  for (int s = 0; s < 4; ++s) {
    for (int line = 1; line <= reaches[s];) {
      const int size = line <= near_bins ? kBlock : kFarBlock;
      blocks[s].push_back({line, std::min(line + size - 1, reaches[s])});
      line += size;
    }
  }
  return CornerChoice::all(std::move(blocks));
}

void CornerBounds::prepare(const HoughSpace& space) {
  if (!space.free_map().charges()) return;
  for (int groups = 1; groups <= VoteStrips::kGroups; ++groups)
    SquareCharges::prepare(space, kBlock / groups);
}

void CornerBounds::lay_out(const HoughSpace& space, const NearVotes& votes, const CornerChoice& choice) {
  votes_ = &votes;
  toll_ = space.penalties().per_bin;
  asked_ = may_ = choice;
  std::array<int, 4> near{};
  for (int s = 0; s < 4; ++s) {
    const auto& blocks = may_.blocks[s];
    near[s] = static_cast<int>(std::find_if(blocks.begin(), blocks.end(), is_far) - blocks.begin());
    near_at_[s].assign(
        blocks.empty() ? 0 : static_cast<std::size_t>(squares_before(s, may_.count(s) - 1)) + 1, -1);
    for (int b = 0; b < near[s]; ++b) near_at_[s][static_cast<std::size_t>(squares_before(s, b))] = b;
  }
  strips_.lay_out(may_.blocks, near, space.penalties().contour_bins, votes.farthest_bins() + 2);
  corners_.lay_out(may_.blocks, votes.scale_bits() + 1);
}

void CornerBounds::build(const HoughSpace& space, int angle, const HoughSpace::Bins& robot, int score,
                         int most_of_walls, const PlaneLimits& limits) {
  const Plane plane{space, angle, robot};
  strips_.cast(*votes_, space, angle, robot);
  bound_far_lines(plane);
  most_inside_ = most_of_walls - score;
  may_.corners = asked_.corners;
  corner_count_ = 0;
  for (int groups = 1; groups <= VoteStrips::kGroups; ++groups) {
    corners_.clear();
    for (int d = 0; d < 2; ++d) {
      for (int p = 0; p < 2; ++p) add_corners(plane, {d, p}, groups);
    }
    corners_.solve(score, limits.d, limits.p);
    if (corners_.bound() < score || !space.free_map().charges()) return;
    may_.corners = corners_.choice().corners;
  }
}

bool CornerBounds::has_far() const {
  for (int s = 0; s < 4; ++s) {
    for (int block = strips_.near(s); block < choice().count(s); ++block) {
      if (choice().last_partner(s, block, 0) >= 0 || choice().last_partner(s, block, 1) >= 0) return true;
    }
  }
  return false;
}

/// A far line is part of two corners, and what it holds altogether is shared out between them.
void CornerBounds::bound_far_lines(const Plane& plane) {
  for (int s = 0; s < 4; ++s) {
    const auto sums = s < kD41 ? plane.space.sums_by_d(plane.angle) : plane.space.sums_by_p(plane.angle);
    const int first = s < kD41 ? plane.robot.d : plane.robot.p, step = s % 2 ? 1 : -1;
    far_[s].clear();
    for (int block = strips_.near(s); block < may_.count(s); ++block) {
      const LineBlock& lines = may_.blocks[s][static_cast<std::size_t>(block)];
      int most = 0;
      for (int line = lines.nearest; line <= lines.farthest; ++line)
        most = std::max(most, sums[static_cast<std::size_t>(first + step * line)]);
      far_[s].push_back((most + 1) / 2);
    }
  }
}

void CornerBounds::add_corners(const Plane& plane, Quadrant q, int groups) {
  sum_inside(q);
  find_reach(q);
  if (q.rows == 0) return;
  corner_count_ += q.rows * q.columns;
  charge(plane, q, groups);
  if (groups == 1) {
    hold<1>(q.d_side(), q.p, q.columns);
    hold<1>(q.p_side(), q.d, q.rows);
  } else {
    hold<2>(q.d_side(), q.p, q.columns);
    hold<2>(q.p_side(), q.d, q.rows);
  }
  put_together(q);
}

/// What lies inside grows with the distance from the robot: beyond some block no corner matters.
void CornerBounds::sum_inside(Quadrant& q) {
  q.rows = may_.count(q.d_side());
  q.columns = may_.count(q.p_side());
  inside_.resize(static_cast<std::size_t>(q.rows * q.columns));
  reach_.assign(static_cast<std::size_t>(q.rows), 0);
  int reach = q.columns;
  for (int m = 0; m < q.rows && reach > 0; ++m) {
    const int* const votes = strips_.inside(q.d_side(), m).data() + strips_.inside_column(q.p_side());
    int* const here = inside_.data() + m * q.columns;
    int sum = 0, n = 0;
    for (; n < reach; ++n) {
      sum += votes[n];
      here[n] = sum + (m > 0 ? here[n - q.columns] : 0);
      if (here[n] > most_inside_) break;
    }
    reach_[static_cast<std::size_t>(m)] = reach = n;
  }
}

/// Beyond the last corner that can matter nothing need be known.
void CornerBounds::find_reach(Quadrant& q) {
  int reach = 0;
  for (int m = q.rows - 1; m >= 0; --m) {
    int& last = reach_[static_cast<std::size_t>(m)];
    while (last > reach && !may_.may(q.d, q.p, m, last - 1)) --last;
    reach = last = std::max(last, reach);
    if (reach == 0) q.rows = m;
  }
  q.columns = reach;
}

/// The least charge in each square of kBlock / groups lines of d and of p that a near line goes through on
/// the way to a corner.
void CornerBounds::charge(const Plane& plane, const Quadrant& q, int groups) {
  const int d_width = strips_.width(q.d_side()), p_width = strips_.width(q.p_side());
  const int rows = squares_before(q.d_side(), q.rows - 1) + 1,
            columns = squares_before(q.p_side(), q.columns - 1) + 1;
  charge_[0].assign(static_cast<std::size_t>(columns * groups * groups * d_width), 0);
  charge_[1].assign(static_cast<std::size_t>(rows * groups * groups * p_width), 0);
  if (!plane.space.free_map().charges()) return;
  const SquareCharges squares(plane.space, plane.angle, plane.robot, q.d, q.p, kBlock / groups);
  const auto &d_near = near_at_[q.d_side()], &p_near = near_at_[q.p_side()];
  for (int square = 0, next = 0; square < rows; ++square) {
    while (squares_before(q.d_side(), next) < square) ++next;
    const int m = d_near[static_cast<std::size_t>(square)], reach = reach_[static_cast<std::size_t>(next)];
    const int last = squares_before(q.p_side(), reach - 1);
    for (int row = square * groups; row < (square + 1) * groups; ++row) {
      std::uint8_t* const of_d = charge_[0].data() + row % groups * d_width + m;
      std::uint8_t* const of_p = charge_[1].data() + row * groups * p_width;
      const auto charge_at = [&](int across) {
        const int n = p_near[static_cast<std::size_t>(across)];
        for (int h = 0; h < groups; ++h) {
          const auto charge = static_cast<std::uint8_t>(squares.at(row, across * groups + h));
          if (m >= 0) of_d[(across * groups + h) * groups * d_width] = charge;
          if (n >= 0) of_p[h * p_width + n] = charge;
        }
      };
      if (m >= 0)
        for (int across = 0; across <= last; ++across) charge_at(across);
      else
        for (int n = 0; n < std::min(reach, strips_.near(q.p_side())); ++n)
          charge_at(squares_before(q.p_side(), n));
    }
  }
}

/// The most that a line of each block holds up to the far end of each block along, less what it costs up to
/// the near end: a corner lies one bin beyond the squares before its block.
template <int groups>
void CornerBounds::hold(int side, int half, int rows) {
  constexpr int kSize = kBlock / groups;
  const int width = strips_.width(side), axis = side / 2, other = 2 * (1 - axis) + half;
  const int unit = 1 << votes_->scale_bits();
  walls_[axis].resize(static_cast<std::size_t>(rows * stride(side)));
  spent_.assign(static_cast<std::size_t>(groups * width), 0);
  const std::uint8_t* charge = charge_[axis].data();
  const auto subtract = [&](const auto* first, const auto* second, int scale, int toll, int* out) {
    const int *of_first = spent_.data(), *of_second = spent_.data() + (groups - 1) * width;
    for (int m = 0; m < width; ++m) {
      const int a = first[m] * scale - of_first[m], b = second[m] * scale - of_second[m];
      out[m] = (a > b ? a : b) - toll;
    }
  };
  for (int along = 0, square = 0; along < rows; ++along) {
    for (; square < squares_before(other, along); ++square, charge += groups * groups * width) {
      for (int i = 0; i < groups * width; ++i) {
        const int last = charge[(groups - 1) * groups * width + i];
        spent_[i] += kSize * (groups == 1 ? last : charge[i] + last);
      }
    }
    int* const out = walls_[axis].data() + along * stride(side);
    const int toll = toll_ * may_.blocks[other][static_cast<std::size_t>(along)].nearest;
    if (along < strips_.near(other))
      subtract(strips_.most(side, half, along, 0).data(), strips_.most(side, half, along, 1).data(), unit,
               toll, out);
    else
      subtract(strips_.most_beyond(side, half, 0).data(), strips_.most_beyond(side, half, 1).data(), 1, toll,
               out);
    for (std::size_t m = 0; m < far_[side].size(); ++m)
      out[width + static_cast<int>(m)] = far_[side][m] - toll;
  }
}

void CornerBounds::put_together(const Quadrant& q) {
  const int d_stride = stride(q.d_side()), p_stride = stride(q.p_side()), width = may_.count(q.p_side());
  for (int m = 0; m < q.rows; ++m) {
    const int *d_wall = walls_[0].data() + column(q.d_side(), m), *p_wall = walls_[1].data() + m * p_stride,
              *inside = inside_.data() + m * width;
    for (int n = 0; n < reach_[static_cast<std::size_t>(m)]; ++n) {
      if (may_.may(q.d, q.p, m, n))
        corners_.set(q.d, q.p, m, n, d_wall[n * d_stride] + p_wall[column(q.p_side(), n)] - inside[n]);
    }
  }
}

}  // namespace enfilade::room_detector
