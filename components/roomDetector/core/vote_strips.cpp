// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/vote_strips.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::room_detector {
namespace {

constexpr int kLanes = 8;  // of 16 bits, in a register

int side_of(int axis, bool is_far) { return 2 * axis + is_far; }

void add_to(std::int16_t* sum, const std::int16_t* other, int count) {
  for (int i = 0; i < count; ++i) sum[i] = static_cast<std::int16_t>(sum[i] + other[i]);
}

void raise(std::int16_t* most, const std::int16_t* other, int count) {
  for (int i = 0; i < count; ++i) most[i] = other[i] > most[i] ? other[i] : most[i];
}

}  // namespace

void VoteStrips::lay_out(const LineBlocks& blocks, const std::array<int, 4>& near, int margin, int span) {
  span_ = span;
  blocks_ = blocks;
  near_ = near;
  has_beyond_ = false;
  std::array<int, 2> reach{};
  for (int s = 0; s < 4; ++s) {
    count_[s] = static_cast<int>(blocks[s].size());
    width_[s] = (near[s] + kLanes - 1) / kLanes * kLanes;
    has_beyond_ |= near[s] < count_[s];
    if (near[s] > 0)
      reach[s / 2] = std::max(reach[s / 2], blocks[s][static_cast<std::size_t>(near[s] - 1)].farthest);
  }
  reach_bins_ = static_cast<int>(std::hypot(reach[0], reach[1])) + 1;
  inside_width_ = count_[kD41] + count_[kD23] + 1;
  inside_.assign(static_cast<std::size_t>((count_[kD12] + count_[kD34] + 1) * inside_width_), 0);
  for (int axis = 0; axis < 2; ++axis) lay_out_axis(axis, blocks);
  for (int s = 0; s < 4; ++s) lay_out_inside(s, blocks[s], margin);
}

/// In a row the first lines of all blocks come first, then the second lines, and so on. What no strip holds
/// goes to one more column and one more row at the end.
void VoteStrips::lay_out_axis(int axis, const LineBlocks& blocks) {
  Axis& a = axes_[axis];
  const int before = side_of(axis, false), behind = side_of(axis, true);
  const int across = side_of(1 - axis, false);
  const int nowhere = kBlock * (width_[before] + width_[behind]);
  a.stride = nowhere + kLanes;
  a.rows = {near_[across], near_[across + 1]};
  const int rows = a.rows[0] + a.rows[1];
  a.column_of.assign(static_cast<std::size_t>(2 * span_), nowhere);
  a.row_of.assign(static_cast<std::size_t>(2 * span_), rows * a.stride);
  a.strips.assign(static_cast<std::size_t>((rows + 1) * a.stride), 0);
  for (const int s : {before, behind}) {
    lay_out_columns(s, blocks[s]);
    most_[s].resize(static_cast<std::size_t>(rows * kGroups * width_[s]));
    beyond_[s].resize(static_cast<std::size_t>(2 * kGroups * width_[s]));
  }
  for (const int s : {across, across + 1}) lay_out_rows(s, blocks[s]);
  const auto nowhere_inside = static_cast<std::size_t>(2 * span_);
  inside_of_[axis].assign(nowhere_inside,
                          axis == 0 ? (count_[kD12] + count_[kD34]) * inside_width_ : inside_width_ - 1);
}

void VoteStrips::lay_out_columns(int side, const std::vector<LineBlock>& blocks) {
  auto& column_of = axes_[side / 2].column_of;
  for (int block = 0; block < near_[side]; ++block) {
    const LineBlock& lines = blocks[static_cast<std::size_t>(block)];
    for (int line = lines.nearest; line <= lines.farthest && line < span_; ++line)
      column_of[place(side, line)] = first_column(side) + (line - lines.nearest) * width_[side] + block;
  }
}

/// Rows of the other axis. What lies between two blocks counts for the farther one.
void VoteStrips::lay_out_rows(int side, const std::vector<LineBlock>& blocks) {
  Axis& other = axes_[1 - side / 2];
  const int first = side % 2 ? other.rows[0] : 0;
  for (int block = 0, away = 0; block < near_[side]; ++block) {
    for (; away < blocks[static_cast<std::size_t>(block)].farthest && away < span_; ++away)
      other.row_of[place(side, side % 2 ? away : away + 1)] = (first + block) * other.stride;
  }
}

/// A vote is inside from the first line on that is more than the margin farther out. One within the margin of
/// the axis may belong to the contour on the other side: it counts for no bound.
void VoteStrips::lay_out_inside(int side, const std::vector<LineBlock>& blocks, int margin) {
  auto& inside_of = inside_of_[side / 2];
  const int first = side % 2 ? count_[side - 1] : 0, step = side < kD41 ? inside_width_ : 1;
  for (int block = 0, away = margin + 1; block < count_[side]; ++block) {
    for (; away + margin < blocks[static_cast<std::size_t>(block)].nearest && away < span_; ++away)
      inside_of[place(side, away)] = (first + block) * step;
  }
}

void VoteStrips::cast(const NearVotes& votes, const HoughSpace& space, int angle,
                      const HoughSpace::Bins& robot) {
  for (Axis& axis : axes_) std::fill(axis.strips.begin(), axis.strips.end(), 0);
  std::fill(inside_.begin(), inside_.end(), 0);
  const int *row = inside_of_[0].data() + span_ - robot.d, *column = inside_of_[1].data() + span_ - robot.p;
  cast_votes_ = votes.count_within(reach_bins_);
  votes.for_each_chunk(space.binning(angle), cast_votes_, [&](const NearVotes::Chunk& c) {
    // One table after the other: together they are more than the nearest cache holds.
    add_strips(axes_[0], {c.d, c.p, c.scaled, c.size}, robot.d, robot.p, 1);
    add_strips(axes_[1], {c.p, c.d, c.scaled, c.size}, robot.p, robot.d, -1);
    for (int i = 0; i < c.size; ++i)
      inside_[static_cast<std::size_t>(row[c.d[i]] + column[c.p[i]])] += c.interior[i];
  });
  for (int axis = 0; axis < 2; ++axis) sum_up(axis);
  for (int s = 0; s < 4 && has_beyond_; ++s)
    look_beyond(s, s < kD41 ? space.sums_by_d(angle) : space.sums_by_p(angle), s < kD41 ? robot.d : robot.p,
                votes.scale_bits());
}

/// Walls on lines behind the robot (shifted = 1) or before it (−1) begin one bin farther along.
void VoteStrips::add_strips(Axis& axis, const Votes& votes, int line_robot, int along_robot, int shifted) {
  const int *column_of = axis.column_of.data() + span_ - line_robot,
            *row_of = axis.row_of.data() + span_ - along_robot;
  std::int16_t* const strips = axis.strips.data();
  for (int i = 0; i < votes.size; ++i) {
    const int shift = shifted * (votes.line[i] - line_robot) > 0;
    std::int16_t& strip = strips[column_of[votes.line[i]] + row_of[votes.along[i] - shift]];
    strip = static_cast<std::int16_t>(strip + votes.scaled[i]);
  }
}

void VoteStrips::sum_up(int axis) {
  Axis& a = axes_[axis];
  const int before = side_of(axis, false), behind = side_of(axis, true);
  for (int half = 0; half < 2; ++half) {
    auto& sum = a.sums[half];
    sum.assign(static_cast<std::size_t>(a.stride), 0);
    for (int along = 0; along < a.rows[half]; ++along) {
      add_to(sum.data(), a.strips.data() + (half * a.rows[0] + along) * a.stride, a.stride);
      raise_most(before, half, along, sum.data());
      raise_most(behind, half, along, sum.data() + first_column(behind));
    }
  }
}

void VoteStrips::raise_most(int side, int half, int along, const std::int16_t* sum) {
  std::int16_t* most = most_[side].data() + index(half, along, side);
  for (int group = 0; group < kGroups; ++group, most += width_[side]) {
    std::copy_n(sum, width_[side], most);
    sum += width_[side];
    for (int line = 1; line < kBlock / kGroups; ++line, sum += width_[side]) raise(most, sum, width_[side]);
  }
}

/// A line holds no more before the robot than all of it less what is near behind it, and the other way round.
void VoteStrips::look_beyond(int side, std::span<const int> line_sums, int robot, int scale_bits) {
  const Axis& a = axes_[side / 2];
  std::fill(beyond_[side].begin(), beyond_[side].end(), 0);
  for (int half = 0; half < 2; ++half) {
    const std::int16_t* const other = a.sums[1 - half].data() + first_column(side);
    int* const beyond = beyond_[side].data() + half * kGroups * width_[side];
    for (int block = 0; block < near_[side]; ++block) {
      const LineBlock& lines = blocks_[side][static_cast<std::size_t>(block)];
      for (int line = lines.nearest; line <= lines.farthest; ++line) {
        const int within = line - lines.nearest;
        const int known = scale_bits == 0 ? other[within * width_[side] + block] : 0;
        int& most = beyond[within / (kBlock / kGroups) * width_[side] + block];
        most = std::max(most,
                        line_sums[static_cast<std::size_t>(side % 2 ? robot + line : robot - line)] - known);
      }
    }
  }
}

std::size_t VoteStrips::index(int half, int along, int side) const {
  return static_cast<std::size_t>((half * axes_[side / 2].rows[0] + along) * kGroups * width_[side]);
}

std::span<const std::int16_t> VoteStrips::most(int side, int half, int along, int group) const {
  return {most_[side].data() + index(half, along, side) + group * width_[side],
          static_cast<std::size_t>(width_[side])};
}

std::span<const int> VoteStrips::most_beyond(int side, int half, int group) const {
  return {beyond_[side].data() + (half * kGroups + group) * width_[side],
          static_cast<std::size_t>(width_[side])};
}

std::span<const int> VoteStrips::inside(int d_side, int d_block) const {
  const int row = (d_side == kD12 ? 0 : count_[kD12]) + d_block;
  return {inside_.data() + static_cast<std::ptrdiff_t>(row) * inside_width_,
          static_cast<std::size_t>(inside_width_)};
}

}  // namespace enfilade::room_detector
