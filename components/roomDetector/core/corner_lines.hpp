// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "components/roomDetector/core/best_window.hpp"
#include "components/roomDetector/core/corner_choice.hpp"
#include "components/roomDetector/core/near_votes.hpp"

namespace enfilade::room_detector {

/// The terms of eq. 5 that belong to some corners of one plane: two half walls, their tolls and the interior
/// up to the robot's bin. Only the lines of these corners are walked along, and only as far as they need.
class CornerLines {
 public:
  void build(const HoughSpace& space, const NearVotes& votes, int angle, const HoughSpace::Bins& robot,
             const CornerChoice& choice);

  /// The lines of one direction, from the first bin to the last.
  const std::vector<int>& lines(int axis) const { return axes_[axis].lines; }
  /// How many of them lie before the robot.
  int before(int axis) const { return axes_[axis].before; }
  /// Writes the terms of the corners on one line of d, in the order of the lines of p; kNoCorner where none
  /// was asked for.
  void fill(int d_line, int* terms) const;
  /// What building took, in microseconds or so.
  int work() const { return work_; }
  static constexpr int kNoCorner = kNever / 8;

 private:
  /// The bins of a line that are walked along, and where their weights are.
  struct Stretch {
    int from = 0, to = 0;
    std::size_t weights = 0;
  };
  struct Axis {
    std::vector<int> lines;
    std::vector<int> block_of;  // of each line, among those of its side
    int before = 0;
    std::vector<Stretch> stretches;
    std::vector<int> row_of;   // by bin from the robot's, plus span_; -1 = none
    int edges = 0;             // what lies inside begins or ends at these bins
    std::vector<int> edge_of;  // of each bin, how many edges come up to it
    std::vector<int> edge_of_line;
    std::vector<int> weights;
    std::vector<int> halves;  // of each line up to each line of the other axis
  };

  void take_lines(int axis);
  void lay_out_stretches(int axis);
  void lay_out_edges(int axis, int margin);
  void cast(const HoughSpace& space, const NearVotes& votes, int angle);
  void sum_up_interior();
  void walk(const HoughSpace& space, int angle, int axis);
  void walk_half(const FreeMap& free, const HoughSpace::BinCentres& centres, int axis, int row, int half);
  int farthest_partner(int axis, int row, int half) const;
  int count(int axis) const { return static_cast<int>(axes_[axis].lines.size()); }

  const CornerChoice* choice_ = nullptr;
  std::array<int, 2> robot_{};
  int span_ = 0, toll_ = 0, work_ = 0;
  std::array<int, 2> robot_edge_{};
  std::array<Axis, 2> axes_;
  std::vector<int> interior_;
};

}  // namespace enfilade::room_detector
