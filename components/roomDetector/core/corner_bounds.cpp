// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/corner_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::room_detector {
namespace {

constexpr int kBlock = CornerBounds::kBlock;

int blocks_of(int lines) { return (lines + kBlock - 1) / kBlock; }
std::size_t at(int row, int columns, int column) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
}

}  // namespace

void CornerBounds::build(const HoughSpace& space, int angle, const HoughSpace::Bins& robot,
                         const Reaches& reaches) {
  const int lines[] = {reaches.d12, reaches.d34, reaches.d41, reaches.d23};
  for (int s = 0; s < 4; ++s) {
    sides_[s].lines = lines[s];
    sides_[s].blocks = blocks_of(lines[s]);
  }
  for (int s = 0; s < 4; ++s) {
    for (int half = 0; half < 2; ++half) {
      const int along = sides_[s < 2 ? 2 + half : half].blocks;
      sides_[s].strips[half].assign(at(along, sides_[s].lines, 0), 0);
    }
  }
  for (int d = 0; d < 2; ++d) {
    for (int p = 0; p < 2; ++p)
      inside_[d][p].assign(at(sides_[d].blocks + 1, sides_[2 + p].blocks + 1, 0), 0);
  }
  cast(space, angle, robot);
  for (int s = 0; s < 4; ++s) {
    for (int half = 0; half < 2; ++half)
      sum_strips(sides_[s], half, sides_[s < 2 ? 2 + half : half].blocks, space.penalties().per_bin);
  }
  if (space.free_map().charges())
    space.free_map().erode((0.5 * kBlock + 1.0) * std::sqrt(2.0) * space.lattice().step_m());
  for (int d = 0; d < 2; ++d) {
    for (int p = 0; p < 2; ++p) add_quadrant(space, angle, robot, d, p);
  }
  combine();
}

void CornerBounds::cast(const HoughSpace& space, int angle, const HoughSpace::Bins& robot) {
  const int margin = space.penalties().contour_bins;
  for (const HoughSpace::WallVote& vote : space.wall_votes()) {
    const HoughSpace::Bins b = space.bins_at(angle, vote.x_m, vote.y_m);
    if (!space.lattice().holds(b.d) || !space.lattice().holds(b.p)) continue;
    const int d = b.d - robot.d, p = b.p - robot.p;
    // Going round, each wall has its first corner and not its last; so has each half of one at its axis.
    if (d < 0) cast_on_lines(sides_[kD12], -1 - d, p < 0 ? -1 - p : p, p >= 0, vote.occupied);
    if (d > 0) cast_on_lines(sides_[kD34], d - 1, p > 0 ? p - 1 : -p, p > 0, vote.occupied);
    if (p < 0) cast_on_lines(sides_[kD41], -1 - p, d > 0 ? d - 1 : -d, d > 0, vote.occupied);
    if (p > 0) cast_on_lines(sides_[kD23], p - 1, d < 0 ? -1 - d : d, d >= 0, vote.occupied);
    if (vote.interior == 0 || std::abs(d) <= margin || std::abs(p) <= margin) continue;
    // Inside from the first line on that is more than the margin farther out.
    const int d_side = d > 0, p_side = p > 0;
    const int d_block = (std::abs(d) + margin + kBlock - 1) / kBlock,
              p_block = (std::abs(p) + margin + kBlock - 1) / kBlock;
    if (d_block <= sides_[d_side].blocks && p_block <= sides_[2 + p_side].blocks)
      inside_[d_side][p_side][at(d_block, sides_[2 + p_side].blocks + 1, p_block)] += vote.interior;
  }
}

void CornerBounds::cast_on_lines(Side& side, int line, int other_distance, bool is_behind, int count) {
  if (line >= side.lines) return;
  auto& strips = side.strips[is_behind];
  const std::size_t i = at(other_distance / kBlock, side.lines, line);
  if (i < strips.size()) strips[i] += count;
}

/// walls(m, n): the most that a line of block m holds up to the far end of block n along, less the toll up to
/// the near end.
void CornerBounds::sum_strips(Side& side, int half, int blocks_along, int toll) {
  auto& strips = side.strips[half];
  auto& walls = side.walls[half];
  walls.resize(at(side.blocks, blocks_along, 0));
  for (int n = 0; n < blocks_along; ++n) {
    int* strip = strips.data() + at(n, side.lines, 0);
    if (n > 0) {
      const int* before = strip - side.lines;
      for (int i = 0; i < side.lines; ++i) strip[i] += before[i];
    }
    for (int m = 0; m < side.blocks; ++m) {
      const int last = std::min(side.lines, (m + 1) * kBlock);
      int most = strip[m * kBlock];
      for (int i = m * kBlock + 1; i < last; ++i) most = strip[i] > most ? strip[i] : most;
      walls[at(m, blocks_along, n)] = most - toll * (n * kBlock + 1);
    }
  }
}

void CornerBounds::add_quadrant(const HoughSpace& space, int angle, const HoughSpace::Bins& robot, int d_side,
                                int p_side) {
  const Side &d = sides_[d_side], &p = sides_[2 + p_side];
  auto& corners = corners_[d_side][p_side];
  auto& inside = inside_[d_side][p_side];
  corners.resize(at(d.blocks, p.blocks, 0));
  line_d_.assign(static_cast<std::size_t>(p.blocks + 1), 0);  // interior votes of rows up to m, by column
  line_p_.assign(static_cast<std::size_t>(p.blocks), 0);      // charges on p lines up to block m
  const bool charges = space.free_map().charges();
  const HoughSpace::BinCentres centres = space.bin_centres(angle);
  const int d_way = d_side ? 1 : -1, p_way = p_side ? 1 : -1;
  for (int m = 0; m < d.blocks; ++m) {
    int votes = 0, charge_d = 0;
    for (int n = 0; n < p.blocks; ++n) {
      line_d_[static_cast<std::size_t>(n)] += inside[at(m, p.blocks + 1, n)];
      votes += line_d_[static_cast<std::size_t>(n)];
      int& charge_p = line_p_[static_cast<std::size_t>(n)];
      corners[at(m, p.blocks, n)] = d.walls[p_side][at(m, p.blocks, n)] +
                                    p.walls[d_side][at(n, d.blocks, m)] - votes - charge_d - charge_p;
      if (!charges) continue;
      const int bin_d = robot.d + d_way * (m * kBlock + kBlock / 2),
                bin_p = robot.p + p_way * (n * kBlock + kBlock / 2);
      if (bin_d < 0 || bin_p < 0 || bin_d >= space.lattice().bins() || bin_p >= space.lattice().bins())
        continue;
      const int least =
          kBlock * space.free_map().least_near(centres.x_at(bin_d, bin_p), centres.y_at(bin_d, bin_p));
      charge_d += least;
      charge_p += least;
    }
  }
}

/// Every pair of blocks of d₁₂ and d₃₄ with the best block of d₄₁ and the best of d₂₃.
void CornerBounds::combine() {
  const auto& [d12, d34, d41, d23] = sides_;
  for (int s = 0; s < 4; ++s) best_with_[s].assign(static_cast<std::size_t>(sides_[s].blocks), kNever);
  bound_ = kNever;
  // Best of the corners with each line of p, over all pairs of lines of d: a bound for lines of p.
  std::array<std::vector<int>, 2> by_p;
  std::array<int, 2> most_p{};
  for (int half = 0; half < 2; ++half) {
    const int n = sides_[2 + half].blocks;
    by_p[half].assign(static_cast<std::size_t>(n), kNever);
    std::vector<int> other(static_cast<std::size_t>(n), kNever);
    for (int side = 0; side < 2; ++side) {
      auto& most = side == 0 ? by_p[half] : other;
      for (int m = 0; m < sides_[side].blocks; ++m) {
        const int* row = corners_[side][half].data() + at(m, n, 0);
        for (int k = 0; k < n; ++k) most[k] = row[k] > most[k] ? row[k] : most[k];
      }
    }
    for (int k = 0; k < n; ++k) by_p[half][k] += other[k];
    most_p[half] = *std::max_element(by_p[half].begin(), by_p[half].end());
  }
  for (int half = 0; half < 2; ++half) {
    for (std::size_t k = 0; k < by_p[half].size(); ++k)
      best_with_[2 + half][k] = by_p[half][k] + most_p[1 - half];
  }
  for (int i = 0; i < d12.blocks; ++i) {
    for (int l = 0; l < d34.blocks; ++l) {
      int sum = 0;
      std::array<int, 2> where{};
      for (int half = 0; half < 2; ++half) {
        const int n = sides_[2 + half].blocks;
        const int* left = corners_[0][half].data() + at(i, n, 0);
        const int* right = corners_[1][half].data() + at(l, n, 0);
        int most = kNever;
        for (int k = 0; k < n; ++k) most = left[k] + right[k] > most ? left[k] + right[k] : most;
        sum += most;
      }
      best_with_[0][static_cast<std::size_t>(i)] = std::max(best_with_[0][static_cast<std::size_t>(i)], sum);
      best_with_[1][static_cast<std::size_t>(l)] = std::max(best_with_[1][static_cast<std::size_t>(l)], sum);
      if (sum <= bound_) continue;
      bound_ = sum;
      for (int half = 0; half < 2; ++half) {
        const int n = sides_[2 + half].blocks;
        int most = kNever;
        for (int k = 0; k < n; ++k) {
          const int both = corners_[0][half][at(i, n, k)] + corners_[1][half][at(l, n, k)];
          if (both <= most) continue;
          most = both;
          where[half] = k;
        }
      }
      best_ = {(i + 1) * kBlock, (l + 1) * kBlock, (where[0] + 1) * kBlock, (where[1] + 1) * kBlock};
    }
  }
  best_ = {std::min(best_.d12, d12.lines), std::min(best_.d34, d34.lines), std::min(best_.d41, d41.lines),
           std::min(best_.d23, d23.lines)};
}

Reaches CornerBounds::reaches_for(int score) const {
  std::array<int, 4> lines{};
  for (int s = 0; s < 4; ++s) {
    for (int m = 0; m < sides_[s].blocks; ++m) {
      if (best_with_[s][static_cast<std::size_t>(m)] >= score)
        lines[s] = std::min(sides_[s].lines, (m + 1) * kBlock);
    }
  }
  return {lines[0], lines[1], lines[2], lines[3]};
}

}  // namespace enfilade::room_detector
