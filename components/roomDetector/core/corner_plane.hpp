// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "components/roomDetector/core/corner_bounds.hpp"

namespace enfilade::room_detector {

/// The rectangles around the robot in one plane, bin by bin, out to some reach: eq. 5 as the sum of four
/// corner terms (see CornerBounds), so that a rectangle is one row of corners left of the robot and one right
/// of it, added up.
class CornerPlane {
 public:
  /// Spells the plane out.
  void build(const HoughSpace& space, int angle, const HoughSpace::Bins& robot, const Reaches& reaches);
  /// Improves `best` by every rectangle of the plane within the reaches that can beat it.
  void search(const PlaneLimits& limits, Incumbent& best);

 private:
  /// All corners of one side of the robot: a row for each line of d, a column for each line of p.
  struct Corners {
    std::vector<int> lines;  // d of each row, in order
    std::vector<int> terms;  // row by row
    std::vector<int> most;   // of each row: best d₄₁ plus best d₂₃
  };

  void cast(const HoughSpace& space, const HoughSpace::Bins& robot, const Reaches& reaches);
  void charge(const HoughSpace& space);
  void accumulate();
  void fill(Corners& corners, int from, int to, bool is_first);
  int interior_at(int d, int p) const;
  void bound_rows(Corners& corners) const;
  bool drop_columns(int score);
  bool drop_rows(int score);
  void keep_columns(Corners& corners, const std::vector<std::size_t>& kept) const;
  int bound_of_pair(std::size_t first, std::size_t second) const;
  void solve_pair(std::size_t first, std::size_t second, const PlaneLimits& limits, Incumbent& best);

  int alpha_ = 0, toll_ = 0, margin_ = 0;
  int first_d_ = 0, first_p_ = 0;  // bins of row and column 0
  int rows_ = 0, columns_ = 0;     // of bins
  int robot_row_ = 0, robot_column_ = 0;
  bool has_interior_ = false;
  std::vector<int> weight_, along_p_, along_d_, interior_;
  std::vector<int> column_p_;  // p of each column of corners, in order
  std::size_t behind_ = 0;     // the first column of d₂₃; those before are of d₄₁
  Corners left_, right_;
};

}  // namespace enfilade::room_detector
