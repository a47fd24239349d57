// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "components/roomDetector/core/corner_blocks.hpp"
#include "components/roomDetector/core/corner_lines.hpp"
#include "components/roomDetector/core/plane_search.hpp"

namespace enfilade::room_detector {

/// The rectangles around the robot in one plane whose sides are among some lines: eq. 5 as the sum of four
/// corner terms (see CornerBounds), so that a rectangle is one row of corners left of the robot and one right
/// of it, added up.
class CornerPlane {
 public:
  /// Spells these corners out.
  void build(const HoughSpace& space, const NearVotes& votes, int angle, const HoughSpace::Bins& robot,
             const CornerChoice& choice);
  /// What that took, in microseconds or so.
  int work() const { return corner_lines_.work(); }
  /// Improves `best` by every rectangle of these corners that can beat it.
  void search(const PlaneLimits& limits, Incumbent& best);

 private:
  /// All corners of one side of the robot: a row for each line of d, a column for each line of p.
  struct Corners {
    std::vector<int> lines;  // d of each row, in order
    std::vector<int> terms;  // row by row
    std::vector<int> most;   // of each row: best d₄₁ plus best d₂₃
  };

  void bound_rows(Corners& corners) const;
  bool drop_columns(int score);
  bool drop_rows(int score);
  bool drop_lines(int score);
  void keep_columns(Corners& corners, const std::vector<std::size_t>& kept) const;
  void lay_out_blocks();
  void fill_blocks();
  void search_blocks(const CornerBlocks::Pair& pair, const PlaneLimits& limits, Incumbent& best);
  int bound_of_lines(const int* a, const int* b) const;
  void solve_pair(std::size_t first, std::size_t second, const PlaneLimits& limits, Incumbent& best);

  struct Range {
    std::size_t from, to;
  };
  int alpha_ = 0, scale_bits_ = 0;
  HoughSpace::Bins robot_;
  std::vector<int> column_p_;  // p of each column of corners, in order
  std::size_t behind_ = 0;     // the first column of d₂₃; those before are of d₄₁
  Corners left_, right_;
  CornerLines corner_lines_;
  std::array<std::vector<Range>, 4> ranges_;  // by side: the rows or columns of each block
  CornerBlocks blocks_;
  std::vector<Range> before_, after_;  // columns that the pair of blocks at hand needs
  std::vector<int> sums_;
};

}  // namespace enfilade::room_detector
