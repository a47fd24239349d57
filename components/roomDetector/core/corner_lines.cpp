// SPDX-License-Identifier: Apache-2.0
#include "components/roomDetector/core/corner_lines.hpp"

#include <algorithm>
#include <cmath>

namespace enfilade::room_detector {
namespace {

std::size_t at(int row, int columns, int column) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
}

}  // namespace

void CornerLines::build(const HoughSpace& space, const NearVotes& votes, int angle,
                        const HoughSpace::Bins& robot, const CornerChoice& choice) {
  choice_ = &choice;
  span_ = votes.farthest_bins() + 2;
  toll_ = space.penalties().per_bin;
  robot_ = {robot.d, robot.p};
  for (int axis = 0; axis < 2; ++axis) take_lines(axis);
  for (int axis = 0; axis < 2; ++axis) {
    lay_out_stretches(axis);
    lay_out_edges(axis, space.penalties().contour_bins);
  }
  cast(space, votes, angle);
  sum_up_interior();
  for (int axis = 0; axis < 2; ++axis) walk(space, angle, axis);
  work_ +=
      static_cast<int>((axes_[0].weights.size() + axes_[1].weights.size() + axes_[0].halves.size()) / 300);
}

void CornerLines::take_lines(int axis) {
  Axis& a = axes_[axis];
  a.lines.clear();
  a.block_of.clear();
  const auto add = [&](int block, int line) {
    a.lines.push_back(line);
    a.block_of.push_back(block);
  };
  const auto &before = choice_->blocks[2 * axis], &behind = choice_->blocks[2 * axis + 1];
  for (std::size_t block = before.size(); block-- > 0;) {
    for (int away = before[block].farthest; away >= before[block].nearest; --away)
      add(static_cast<int>(block), robot_[axis] - away);
  }
  a.before = count(axis);
  for (std::size_t block = 0; block < behind.size(); ++block) {
    for (int away = behind[block].nearest; away <= behind[block].farthest; ++away)
      add(static_cast<int>(block), robot_[axis] + away);
  }
}

/// How far out a line need be known: to the last line of a corner on it.
int CornerLines::farthest_partner(int axis, int row, int half) const {
  const Axis& a = axes_[axis];
  const int partner = choice_->last_partner(2 * axis + (row >= a.before), a.block_of[row], half);
  return partner < 0 ? 0 : choice_->blocks[2 * (1 - axis) + half][static_cast<std::size_t>(partner)].farthest;
}

void CornerLines::lay_out_stretches(int axis) {
  Axis& a = axes_[axis];
  a.stretches.clear();
  a.row_of.assign(static_cast<std::size_t>(2 * span_), -1);
  std::size_t size = 0;
  for (int row = 0; row < count(axis); ++row) {
    Stretch stretch{robot_[1 - axis], robot_[1 - axis] + 1, size};
    const bool is_known = row > 0 && a.block_of[row] == a.block_of[row - 1] && row != a.before;
    if (is_known) {
      stretch.from = a.stretches.back().from;
      stretch.to = a.stretches.back().to;
    } else {
      stretch.from -= farthest_partner(axis, row, 0);
      stretch.to += farthest_partner(axis, row, 1);
    }
    a.stretches.push_back(stretch);
    size += static_cast<std::size_t>(stretch.to - stretch.from);
    const int b = a.lines[row] - robot_[axis] + span_;
    if (b >= 0 && b < 2 * span_) a.row_of[static_cast<std::size_t>(b)] = row;
  }
  a.weights.assign(size, 0);
}

void CornerLines::lay_out_edges(int axis, int margin) {
  Axis& a = axes_[axis];
  const int first = robot_[axis] - span_;  // no vote lies beyond the table, before or behind
  const auto place = [&](int bin) { return std::clamp(bin - first, 0, 2 * span_ - 1); };
  a.edge_of_line.clear();
  for (int i = 0; i < count(axis); ++i)
    a.edge_of_line.push_back(place(i < a.before ? a.lines[i] + 1 + margin : a.lines[i] - margin));
  a.edge_of.assign(static_cast<std::size_t>(2 * span_), 0);
  a.edge_of[static_cast<std::size_t>(span_)] = 1;
  for (const int edge : a.edge_of_line) a.edge_of[static_cast<std::size_t>(edge)] = 1;
  a.edges = 0;
  for (int& edge : a.edge_of) edge = a.edges += edge;
  for (int& edge : a.edge_of_line) edge = a.edge_of[static_cast<std::size_t>(edge)] - 1;
  robot_edge_[axis] = a.edge_of[static_cast<std::size_t>(span_)] - 1;
}

void CornerLines::cast(const HoughSpace& space, const NearVotes& votes, int angle) {
  Axis &of_d = axes_[0], &of_p = axes_[1];
  const int edges_p = of_p.edges + 1;
  interior_.assign(at(of_d.edges + 1, edges_p, 0), 0);
  const auto reach = [&](int axis) {
    const auto& lines = axes_[axis].lines;
    return lines.empty() ? 0 : std::max(robot_[axis] - lines.front(), lines.back() - robot_[axis]);
  };
  const int near = votes.count_within(std::hypot(reach(0), reach(1)));
  work_ = 1 + near / 150;
  const int at_d = span_ - robot_[0], at_p = span_ - robot_[1];
  const int *row_d = of_d.row_of.data() + at_d, *row_p = of_p.row_of.data() + at_p,
            *edge_d = of_d.edge_of.data() + at_d, *edge_p = of_p.edge_of.data() + at_p;
  const auto put = [](Axis& a, int row, int along, int occupied) {
    const Stretch& stretch = a.stretches[static_cast<std::size_t>(row)];
    if (along >= stretch.from && along < stretch.to)
      a.weights[stretch.weights + static_cast<std::size_t>(along - stretch.from)] += occupied;
  };
  votes.for_each_chunk(space.binning(angle), near, [&](const NearVotes::Chunk& c) {
    for (int i = 0; i < c.size; ++i) {
      const int d = c.d[i], p = c.p[i];
      if (const int row = row_d[d]; row >= 0) put(of_d, row, p, c.occupied[i]);
      if (const int row = row_p[p]; row >= 0) put(of_p, row, d, c.occupied[i]);
      interior_[static_cast<std::size_t>(edge_d[d] * edges_p + edge_p[p])] += c.interior[i];
    }
  });
}

/// Each entry then holds what lies before its edges.
void CornerLines::sum_up_interior() {
  const int width = axes_[1].edges + 1;
  for (int row = 0; row < axes_[0].edges; ++row) {
    int* const here = interior_.data() + at(row, width, 0);
    int sum = 0;
    for (int c = 0; c < width; ++c) {
      sum += here[c];
      here[c] = sum + (row > 0 ? here[c - width] : 0);
    }
  }
}

void CornerLines::walk(const HoughSpace& space, int angle, int axis) {
  axes_[axis].halves.resize(at(count(axis), count(1 - axis), 0));
  const HoughSpace::BinCentres centres = space.bin_centres(angle);
  for (int row = 0; row < count(axis); ++row) {
    for (int half = 0; half < 2; ++half) walk_half(space.free_map(), centres, axis, row, half);
  }
}

/// Walks outward from the robot along a line. Each wall includes its first corner, going round the contour,
/// and excludes its last; so do its halves, and those on d₃₄ and d₄₁ begin one bin later.
void CornerLines::walk_half(const FreeMap& free, const HoughSpace::BinCentres& centres, int axis, int row,
                            int half) {
  const Axis &a = axes_[axis], &other = axes_[1 - axis];
  const Stretch& stretch = a.stretches[static_cast<std::size_t>(row)];
  const bool is_far = row >= a.before;
  const int shift = is_far == (axis == 0), step = half ? 1 : -1;
  int bin = robot_[1 - axis] + shift + (half ? 0 : -1);
  const int d = axis == 0 ? a.lines[row] : bin, p = axis == 0 ? bin : a.lines[row];
  std::int32_t x = centres.x_at(d, p), y = centres.y_at(d, p);
  const std::int32_t dx = step * (axis == 0 ? -centres.y_by_d : centres.x_by_d),
                     dy = step * (axis == 0 ? centres.x_by_d : centres.y_by_d);
  const int* weight = a.weights.data() + stretch.weights + (bin - stretch.from);
  const bool charges = free.charges();
  int* const out = axes_[axis].halves.data() + at(row, count(1 - axis), 0);
  const int end = half ? count(1 - axis) : -1;
  const int until = half ? stretch.to - 1 - robot_[1 - axis] : robot_[1 - axis] - stretch.from;
  int sum = 0, done = 0;
  for (int c = half ? other.before : other.before - 1; c != end; c += step) {
    const int away = std::abs(other.lines[c] - robot_[1 - axis]);
    if (away > until) return;
    if (charges) {
      for (; done < away; ++done, weight += step, x += dx, y += dy) sum += *weight - free.charge_at(x, y);
    } else {
      for (; done < away; ++done, weight += step) sum += *weight;
    }
    out[c] = sum;
  }
}

void CornerLines::fill(int d_line, int* terms) const {
  const Axis &of_d = axes_[0], &of_p = axes_[1];
  const int columns = count(1), rows = count(0), width = of_p.edges + 1;
  const int* const half_d = of_d.halves.data() + at(d_line, columns, 0);
  const int* const half_p = of_p.halves.data() + d_line;
  const int* const here = interior_.data() + at(of_d.edge_of_line[d_line], width, 0);
  const int* const robot = interior_.data() + at(robot_edge_[0], width, 0);
  const bool is_before = d_line < of_d.before;
  const int away_d = std::abs(of_d.lines[d_line] - robot_[0]);
  const int at_robot = here[robot_edge_[1]] - robot[robot_edge_[1]];
  for (int c = 0, end = 0; c < columns; c = end) {  // block by block
    while (end < columns && of_p.block_of[end] == of_p.block_of[c] &&
           (end < of_p.before) == (c < of_p.before))
      ++end;
    if (!choice_->may(!is_before, c >= of_p.before, of_d.block_of[d_line], of_p.block_of[c])) {
      std::fill(terms + c, terms + end, kNoCorner);
      continue;
    }
    const int sign = is_before == (c < of_p.before) ? 1 : -1;
    for (int i = c; i < end; ++i) {
      const int inside = here[of_p.edge_of_line[i]] - robot[of_p.edge_of_line[i]] - at_robot;
      const int away = away_d + std::abs(of_p.lines[i] - robot_[1]);
      terms[i] = half_d[i] + half_p[static_cast<std::ptrdiff_t>(i) * rows] - toll_ * away - sign * inside;
    }
  }
}

}  // namespace enfilade::room_detector
