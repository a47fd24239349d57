// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/corner_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::room_detector {
namespace {

constexpr int kBlock = CornerBounds::kBlock;

std::size_t at(int row, int columns, int column) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
}

int most_of(const std::vector<int>& values) { return *std::max_element(values.begin(), values.end()); }

int most_of_sum(const int* a, const int* b, int count) {
  int most = kNever;
  for (int i = 0; i < count; ++i) most = a[i] + b[i] > most ? a[i] + b[i] : most;
  return most;
}

/// to[i] = max(to[i], from[i])
void raise(int* to, const int* from, int count) {
  for (int i = 0; i < count; ++i) to[i] = from[i] > to[i] ? from[i] : to[i];
}

}  // namespace

void CornerBounds::build(const HoughSpace& space, int angle, const HoughSpace::Bins& robot,
                         const Reaches& reaches, int score) {
  const int bins = space.lattice().bins(), margin = space.penalties().contour_bins;
  if (reaches != laid_out_ || margin != margin_ || line_[0].size() != 2 * static_cast<std::size_t>(bins))
    lay_out(bins, reaches, margin);
  cast(space, angle, robot);
  for (int s = 0; s < 4; ++s) {
    for (int half = 0; half < 2; ++half)
      sum_strips(sides_[s], half, blocks_along(s, half), space.penalties().per_bin);
  }
  // No bin of a block is farther from its middle, and walls that begin beside the axis are one bin farther.
  if (space.free_map().charges())
    space.free_map().erode((0.5 * kBlock + 1.0) * std::sqrt(2.0) * space.lattice().step_m());
  for (int d = 0; d < 2; ++d) {
    for (int p = 0; p < 2; ++p) add_corners(space, angle, robot, d, p);
  }
  bound_sides();
  if (bound_ >= score) bound_pairs(score);
}

void CornerBounds::lay_out(int bins, const Reaches& reaches, int margin) {
  const int lines[] = {reaches.d12, reaches.d34, reaches.d41, reaches.d23};
  for (int s = 0; s < 4; ++s) {
    sides_[s].lines = lines[s];
    sides_[s].blocks = (lines[s] + kBlock - 1) / kBlock;
  }
  int size = 0;
  for (int s = 0; s < 4; ++s) {
    for (int half = 0; half < 2; ++half) {
      sides_[s].strips[half] = size;
      size += sides_[s].blocks * kBlock * blocks_along(s, half);
    }
  }
  strips_.resize(static_cast<std::size_t>(size) + 1);
  for (const int axis : {0, 1}) lay_out_lines(axis, bins);
  for (int s = 0; s < 4; ++s) lay_out_along(s, bins);
  inside_width_ = sides_[kD41].blocks + sides_[kD23].blocks;
  inside_.resize(at(sides_[kD12].blocks + sides_[kD34].blocks, inside_width_, 1));
  for (const int axis : {0, 1}) lay_out_inside(axis, bins, margin);
  laid_out_ = reaches;
  margin_ = margin;
}

/// A vote is inside from the first line on that is more than the margin farther out. One within the margin of
/// the axis may belong to the contour on the other side: it counts for no bound.
void CornerBounds::lay_out_inside(int axis, int bins, int margin) {
  inside_of_[axis].assign(static_cast<std::size_t>(2 * bins), -1);
  for (int b = -bins; b < bins; ++b) {
    const int block = (std::abs(b) + margin + kBlock - 1) / kBlock, side = 2 * axis + (b > 0);
    if (std::abs(b) > margin && block < sides_[side].blocks)
      inside_of_[axis][static_cast<std::size_t>(b + bins)] =
          ((b > 0 ? sides_[2 * axis].blocks : 0) + block) * (axis == 0 ? inside_width_ : 1);
  }
}

/// In a strip, the first lines of all blocks come first, then the second lines, and so on.
void CornerBounds::lay_out_lines(int axis, int bins) {
  line_[axis].assign(static_cast<std::size_t>(2 * bins), -1);
  for (int b = -bins; b < bins; ++b) {
    const Side& side = sides_[2 * axis + (b > 0)];
    const int line = std::abs(b) - 1;
    if (line >= 0 && line < side.lines)
      line_[axis][static_cast<std::size_t>(b + bins)] = line % kBlock * side.blocks + line / kBlock;
  }
}

/// Going round, each wall has its first corner and not its last, and each half of one likewise: the bin on
/// the axis belongs to one of the halves.
void CornerBounds::lay_out_along(int s, int bins) {
  const Side& side = sides_[s];
  const int first_behind = s == kD12 || s == kD23 ? 0 : 1;
  along_[s].assign(static_cast<std::size_t>(2 * bins), -1);
  for (int b = -bins; b < bins; ++b) {
    const int half = b >= first_behind, distance = half ? b - first_behind : first_behind - 1 - b;
    if (distance / kBlock < blocks_along(s, half))
      along_[s][static_cast<std::size_t>(b + bins)] =
          side.strips[half] + distance / kBlock * side.blocks * kBlock;
  }
}

void CornerBounds::cast(const HoughSpace& space, int angle, const HoughSpace::Bins& robot) {
  std::fill(strips_.begin(), strips_.end(), 0);
  std::fill(inside_.begin(), inside_.end(), 0);
  const int bins = space.lattice().bins();
  const int *line_d = line_[0].data() + bins - robot.d, *line_p = line_[1].data() + bins - robot.p;
  std::array<const int*, 4> along;
  for (int s = 0; s < 4; ++s) along[s] = along_[s].data() + bins - (s < kD41 ? robot.p : robot.d);
  const int *inside_d = inside_of_[0].data() + bins - robot.d,
            *inside_p = inside_of_[1].data() + bins - robot.p;
  const int never = static_cast<int>(inside_.size()) - 1;
  // Votes that no strip holds go into one more bin at the end: a branch for each would cost more than all
  // else.
  const int nowhere = static_cast<int>(strips_.size()) - 1;
  int* const strips = strips_.data();
  const HoughSpace::Binning binning = space.binning(angle);
  for (const HoughSpace::WallVote& vote : space.wall_votes()) {
    HoughSpace::Bins b = binning(vote.x_m, vote.y_m);
    const bool is_outside = static_cast<unsigned>(b.d) >= static_cast<unsigned>(bins) ||
                            static_cast<unsigned>(b.p) >= static_cast<unsigned>(bins);
    if (is_outside) continue;
    const int d = line_d[b.d], along_p = along[b.d > robot.d ? kD34 : kD12][b.p];
    strips[(d | along_p) < 0 ? nowhere : d + along_p] += vote.occupied;
    const int p = line_p[b.p], along_d = along[b.p > robot.p ? kD23 : kD41][b.d];
    strips[(p | along_d) < 0 ? nowhere : p + along_d] += vote.occupied;
    const int row = inside_d[b.d], column = inside_p[b.p];
    inside_[static_cast<std::size_t>((row | column) < 0 ? never : row + column)] += vote.interior;
  }
}

/// walls(n, m): the most that a line of block m holds up to the far end of block n along, less the toll up to
/// the near end.
void CornerBounds::sum_strips(Side& side, int half, int blocks_along, int toll) {
  const int width = side.blocks * kBlock;
  int* strip = strips_.data() + side.strips[half];
  auto& walls = side.walls[half];
  walls.assign(at(blocks_along, side.blocks, 0), kNever);
  for (int n = 0; n < blocks_along; ++n, strip += width) {
    for (int i = 0; n > 0 && i < width; ++i) strip[i] += strip[i - width];
    int* most = walls.data() + at(n, side.blocks, 0);
    for (int line = 0; line < kBlock; ++line) raise(most, strip + line * side.blocks, side.blocks);
    for (int m = 0; m < side.blocks; ++m) most[m] -= toll * (n * kBlock + 1);
  }
}

void CornerBounds::add_corners(const HoughSpace& space, int angle, const HoughSpace::Bins& robot, int d_side,
                               int p_side) {
  const Side &d = sides_[d_side], &p = sides_[kD41 + p_side];
  auto& corners = corners_[d_side][p_side];
  corners.resize(at(d.blocks, p.blocks, 0));
  votes_before_.assign(static_cast<std::size_t>(p.blocks), 0);    // by column: inside, in rows up to this one
  charges_before_.assign(static_cast<std::size_t>(p.blocks), 0);  // and charges in the rows before
  const int first_row = d_side ? sides_[kD12].blocks : 0, first_column = p_side ? sides_[kD41].blocks : 0;
  const FreeMap& free = space.free_map();
  const HoughSpace::BinCentres centres = space.bin_centres(angle);
  const int last = space.lattice().bins() - 1;
  for (int m = 0; m < d.blocks; ++m) {
    int votes = 0, charge_d = 0;
    const int away = m * kBlock + kBlock / 2, bin_d = std::clamp(robot.d + (d_side ? away : -away), 0, last);
    for (int n = 0; n < p.blocks; ++n) {
      const auto column = static_cast<std::size_t>(n);
      votes += votes_before_[column] += inside_[at(first_row + m, inside_width_, first_column + n)];
      corners[at(m, p.blocks, n)] = d.walls[p_side][at(n, d.blocks, m)] +
                                    p.walls[d_side][at(m, p.blocks, n)] - votes - charge_d -
                                    charges_before_[column];
      if (!free.charges()) continue;
      const int across = n * kBlock + kBlock / 2,
                bin_p = std::clamp(robot.p + (p_side ? across : -across), 0, last);
      const int least = kBlock * free.least_near(centres.x_at(bin_d, bin_p), centres.y_at(bin_d, bin_p));
      charge_d += least;
      charges_before_[column] += least;
    }
  }
}

/// What a block of lines can be part of, whatever the other three sides are: the best two corners on it and
/// the best two on any line opposite.
void CornerBounds::bound_sides() {
  for (int half = 0; half < 2; ++half) {
    Side &d = sides_[half], &p = sides_[kD41 + half];
    d.most.assign(static_cast<std::size_t>(d.blocks), 0);
    for (int m = 0; m < d.blocks; ++m) {
      for (int other = 0; other < 2; ++other) {
        const int n = sides_[kD41 + other].blocks;
        const int* row = corners_[half][other].data() + at(m, n, 0);
        d.most[static_cast<std::size_t>(m)] += *std::max_element(row, row + n);
      }
    }
    std::vector<int> of_row(static_cast<std::size_t>(p.blocks));
    p.most.assign(of_row.size(), 0);
    for (int other = 0; other < 2; ++other) {
      std::fill(of_row.begin(), of_row.end(), kNever);
      for (int m = 0; m < sides_[other].blocks; ++m)
        raise(of_row.data(), corners_[other][half].data() + at(m, p.blocks, 0), p.blocks);
      for (std::size_t n = 0; n < of_row.size(); ++n) p.most[n] += of_row[n];
    }
  }
  const std::array<int, 4> most{most_of(sides_[0].most), most_of(sides_[1].most), most_of(sides_[2].most),
                                most_of(sides_[3].most)};
  bound_ = std::min(most[kD12] + most[kD34], most[kD41] + most[kD23]);
  for (int s = 0; s < 4; ++s) {
    for (int& value : sides_[s].most) value += most[s ^ 1];
  }
}

/// Every pair of blocks of d₁₂ and d₃₄ that may hold `score`, with the best block of d₄₁ and the best of d₂₃.
void CornerBounds::bound_pairs(int score) {
  const int opposite = most_of(sides_[kD12].most);  // the bound of all pairs
  std::array<int, 2> lines{};
  const int before = bound_;
  bound_ = kNever;
  for (int i = 0; i < sides_[kD12].blocks; ++i) {
    if (sides_[kD12].most[static_cast<std::size_t>(i)] < score) continue;
    for (int l = 0; l < sides_[kD34].blocks; ++l) {
      const int by_sides = sides_[kD12].most[static_cast<std::size_t>(i)] +
                           sides_[kD34].most[static_cast<std::size_t>(l)] - opposite;
      if (by_sides < score) continue;
      int sum = 0;
      for (int half = 0; half < 2; ++half) {
        const int n = sides_[kD41 + half].blocks;
        sum += most_of_sum(corners_[0][half].data() + at(i, n, 0), corners_[1][half].data() + at(l, n, 0), n);
      }
      if (sum >= score) lines = {std::max(lines[0], i + 1), std::max(lines[1], l + 1)};
      if (sum <= bound_) continue;
      bound_ = sum;
      best_ = {i, l, 0, 0};
    }
  }
  bound_ = std::min(bound_, before);
  if (bound_ < score) return;
  best_.d41 = best_block(best_.d12, best_.d34, 0);
  best_.d23 = best_block(best_.d12, best_.d34, 1);
  const auto out_to = [&](int s, int block) { return std::min(sides_[s].lines, (block + 1) * kBlock); };
  best_ = {out_to(kD12, best_.d12), out_to(kD34, best_.d34), out_to(kD41, best_.d41),
           out_to(kD23, best_.d23)};
  const auto farthest = [&](int s) {
    int block = sides_[s].blocks - 1;
    while (block >= 0 && sides_[s].most[static_cast<std::size_t>(block)] < score) --block;
    return out_to(s, block);
  };
  reaches_ = {out_to(kD12, lines[0] - 1), out_to(kD34, lines[1] - 1), farthest(kD41), farthest(kD23)};
}

int CornerBounds::best_block(int d12, int d34, int half) const {
  const int n = sides_[kD41 + half].blocks;
  int best = 0, most = kNever;
  for (int k = 0; k < n; ++k) {
    const int both = corners_[0][half][at(d12, n, k)] + corners_[1][half][at(d34, n, k)];
    if (both <= most) continue;
    most = both;
    best = k;
  }
  return best;
}

}  // namespace enfilade::room_detector
